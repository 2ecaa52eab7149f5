#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/tune_run.h"
#include "scb/any_packed.h"

namespace scb::app {

/// How queries are made.
struct QueryMethod {
    TuneSetting setting;
    std::optional<PackedLayout> layout;  ///< none: not packed

    bool operator==(const QueryMethod& other) const {
        const auto name = [](const std::optional<PackedLayout>& some) {
            return some ? packed_layout_name(*some) + std::to_string(some->leaf_triangles) : "";
        };
        return setting == other.setting && name(layout) == name(other.layout);
    }
};

/// The work of the same queries before and after a change of the meshes, in all frames of the
/// tuning: with the recommended setting or layout, and with the base setting.
struct TrialWork {
    Work before, after, base_before, base_after;

    /// Whether it saves a tenth of the cost with the recommended setting or layout, or a quarter
    /// with the base. Users who take the best setting lose time by a change for the base.
    bool pays() const;
};

/// Whether `after` costs less by a tenth at least.
bool saves_tenth(const Work& before, const Work& after);

/// The recommended layout or setting, and its work in all frames.
std::pair<QueryMethod, Work> advised(const SceneTuning& tuning);

/// A mesh with its hierarchy, and what queries of it need besides.
struct TrialMesh {
    Mesh mesh;
    AnyHierarchy hierarchy;
    std::optional<AnyPacked> packed{};
    std::vector<std::uint32_t> joined{};  ///< in a self query
};

/// Queries of two bodies of a scene, or of one with itself, whose meshes can be replaced.
class MeshTrial {
  public:
    using Sides = std::array<std::shared_ptr<const TrialMesh>, 2>;

    /// `tuning` has the frames and how hierarchies are built. If both bodies have one mesh, a side
    /// replaces both. `meshes`: in place of the scene's meshes of A and B. Refers to `progress`.
    MeshTrial(const scenes::Scene& scene, std::size_t a, std::size_t b, const SceneTuning& tuning,
              const QueryMethod& method, const TuneProgress& progress,
              std::array<std::optional<Mesh>, 2> meshes = {});

    const Sides& sides() const { return sides_; }
    /// Takes back replacements.
    void set_sides(const Sides& sides) { sides_ = sides; }
    /// Replaces a mesh.
    void place(std::size_t side, Mesh mesh);
    std::size_t mesh_count() const { return one_mesh_ ? 1 : 2; }

    /// The work of the queries in a few of the frames. Less if `progress` ends the trial.
    Work work_in_few_frames() const { return work_of_queries(few_); }
    /// The same in all frames, by any method.
    Work work_by(const QueryMethod& method);

  private:
    Work work_of_queries(const std::vector<Pose>& poses) const;
    Work work_of_query(const Pose& b_to_a) const;

    bool is_self_, one_mesh_;
    BuildOptions build_;
    QueryMethod method_;
    const TuneProgress& progress_;
    std::vector<Pose> poses_, few_;
    Sides sides_;
};

}  // namespace scb::app
