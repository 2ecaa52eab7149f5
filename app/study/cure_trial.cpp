#include "app/study/cure_trial.h"

#include <utility>

#include "core/geometry/mesh_clean.h"

namespace scb::app {
namespace {

/// A mesh is cleaned for a trial if that leaves out so many percent of its triangles.
constexpr std::size_t least_percent = 1;

}  // namespace

std::optional<CureTrial> try_clean_meshes(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                          const SceneTuning& tuning, const TuneProgress& progress) {
    std::array<std::optional<Mesh>, 2> cleaned;
    CureTrial result;
    const std::size_t meshes = scene.bodies[a].mesh == scene.bodies[b].mesh ? 1 : 2;
    for (std::size_t side = 0; side < meshes; ++side) {
        const Mesh& mesh = scene.meshes[scene.bodies[side == 0 ? a : b].mesh].mesh;
        CleanMesh clean = clean_mesh(mesh);
        if (100 * (clean.copies + clean.degenerate) < least_percent * mesh.triangles.size())
            continue;
        result.meshes.push_back({side, clean.copies, clean.degenerate});
        cleaned[side] = std::move(clean.mesh);
    }
    if (result.meshes.empty()) return std::nullopt;
    const auto [best, best_work] = advised(tuning);
    MeshTrial trial(scene, a, b, tuning, best, progress, std::move(cleaned));
    result.work = {best_work, trial.work_by(best), tuning.base().counts,
                   trial.work_by({tuning.base().setting, {}})};
    if (progress.ends() || !result.work.pays()) return std::nullopt;
    return result;
}

}  // namespace scb::app
