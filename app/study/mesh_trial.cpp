#include "app/study/mesh_trial.h"

#include <algorithm>

#include "app/study/layout_time.h"
#include "core/analysis/assumed_time.h"
#include "core/base/parallel_for.h"
#include "scb/any_collide.h"

namespace scb::app {
namespace {

constexpr std::size_t most_few_frames = 5;

bool saves_percent(std::uint64_t percent, const Work& before, const Work& after) {
    return 100 * after.picoseconds <= (100 - percent) * before.picoseconds;
}

}  // namespace

bool TrialWork::pays() const {
    return saves_tenth(before, after) || saves_percent(25, base_before, base_after);
}

bool saves_tenth(const Work& before, const Work& after) { return saves_percent(10, before, after); }

std::pair<QueryMethod, Work> advised(const SceneTuning& tuning) {
    if (const TuneLayout* const layout = tuning.cheapest_layout())
        return {{tuning.rows[layout->row].setting, layout->layout},
                {layout->n_v, layout->n_p, 0, layout->picoseconds}};
    const TuneRow& row = tuning.rows[tuning.recommended()];
    return {{row.setting, {}}, row.counts};
}

MeshTrial::MeshTrial(const scenes::Scene& scene, std::size_t a, std::size_t b,
                     const SceneTuning& tuning, const QueryMethod& method,
                     const TuneProgress& progress, std::array<std::optional<Mesh>, 2> meshes)
    : is_self_(a == b),
      one_mesh_(scene.bodies[a].mesh == scene.bodies[b].mesh),
      build_(tuning.build),
      method_(method),
      progress_(progress) {
    for (const int frame : tuning.frames)
        poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                       scenes::pose_at(scene.bodies[b].motion, frame)));
    const std::size_t step = (poses_.size() + most_few_frames - 1) / most_few_frames;
    for (std::size_t i = 0; i < poses_.size(); i += step) few_.push_back(poses_[i]);
    for (std::size_t side = 0; side < mesh_count(); ++side)
        place(side, meshes[side] ? std::move(*meshes[side])
                                 : Mesh(scene.meshes[scene.bodies[side == 0 ? a : b].mesh].mesh));
}

void MeshTrial::place(std::size_t side, Mesh mesh) {
    BuildOptions options = build_;
    options.split = method_.setting.split;
    options.fit.growth = method_.setting.growth;
    AnyHierarchy hierarchy =
        std::move(build_hierarchies(mesh, std::array{method_.setting.volume}, options).front());
    const auto held = std::make_shared<TrialMesh>(TrialMesh{std::move(mesh), std::move(hierarchy)});
    if (method_.layout)
        held->packed =
            pack_any(*method_.layout, held->hierarchy, held->mesh, "mesh", options.threads);
    if (is_self_) held->joined = joined_vertices(held->mesh);
    sides_[side] = held;
    if (one_mesh_) sides_[1] = held;
}

Work MeshTrial::work_by(const QueryMethod& method) {
    if (method == method_) return work_of_queries(poses_);
    method_ = method;
    for (std::size_t side = 0; side < mesh_count(); ++side) place(side, Mesh(sides_[side]->mesh));
    return work_of_queries(poses_);
}

Work MeshTrial::work_of_queries(const std::vector<Pose>& poses) const {
    std::vector<Work> works(poses.size());
    parallel_for(build_.threads, works.size(), [&](std::size_t i) {
        if (!progress_.ends()) works[i] = work_of_query(poses[i]);
    });
    Work sum;
    for (const Work& work : works) sum += work;
    return sum;
}

Work MeshTrial::work_of_query(const Pose& b_to_a) const {
    const TrialMesh &a = *sides_[0], &b = *sides_[1];
    const TuneSetting& setting = method_.setting;
    if (method_.layout) {
        const PackedCollision found = collide_packed(*a.packed, a.mesh, *b.packed, b.mesh, b_to_a);
        return {
            found.n_v, found.n_p, 0,
            layout_time(setting.volume, *method_.layout, found.n_v, found.n_p, found.pairs.size())};
    }
    CollideOptions options;
    options.overlap = setting.overlap;
    options.descent = setting.descent;
    return work_of(setting.volume, setting.overlap, setting.descent,
                   is_self_ ? collide_self(a.hierarchy, a.mesh, a.joined, options)
                            : collide(a.hierarchy, a.mesh, b.hierarchy, b.mesh, b_to_a, options));
}

}  // namespace scb::app
