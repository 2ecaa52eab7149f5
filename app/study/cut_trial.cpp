#include "app/study/cut_trial.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>

#include "app/study/layout_time.h"
#include "app/study/query_timing.h"
#include "core/analysis/assumed_time.h"
#include "core/base/parallel_for.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_cut.h"
#include "scb/any_collide.h"
#include "scb/any_packed.h"

namespace scb::app {
namespace {

/// More triangles are not cut by their numbers, but all that are as long.
constexpr std::size_t most_seeds = 64;
/// The costly triangles take at least four fifths of the triangle tests.
constexpr std::uint64_t tests_numerator = 4, tests_denominator = 5;
constexpr std::size_t most_pieces = 20'000;
/// In percent of the cost. Users who take the best setting lose time by a cut for the base.
constexpr std::uint64_t least_gain = 10, least_gain_of_base = 25;
/// Lengths are compared in so many frames.
constexpr std::size_t most_trial_frames = 5;
/// Triangles are long if a side is so many times the usual height of tested triangles.
constexpr double long_ratio = 8;

/// The fewest triangles that take four fifths of the tests.
std::vector<std::uint32_t> costly_part(const std::vector<TestedTriangle>& tested,
                                       const Mesh& mesh) {
    const std::uint64_t all = item_tests(tested);
    std::vector<std::uint32_t> costly;
    std::uint64_t tests = 0;
    for (const CostlyTriangle& one : costly_triangles(tested, mesh, tested.size())) {
        costly.push_back(one.tests.triangle);
        tests += one.tests.items;
        if (tests_denominator * tests >= tests_numerator * all) break;
    }
    return costly;
}

double longest_side(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    double longest = 0;
    for (const std::uint32_t t : triangles)
        longest = std::max(longest, triangle_size(corners(mesh, t)).longest_side);
    return longest;
}

/// The median of the heights on the longest sides, each as often as its triangle was tested.
double usual_height(const std::vector<TestedTriangle>& tested, const Mesh& mesh) {
    std::vector<std::pair<double, std::uint64_t>> heights;
    for (const TestedTriangle& one : tested) {
        const TriangleSize size = triangle_size(corners(mesh, one.triangle));
        heights.emplace_back(size.longest_side / size.slenderness, one.items);
    }
    std::sort(heights.begin(), heights.end());
    std::uint64_t left = item_tests(tested) / 2;
    for (const auto& [height, tests] : heights) {
        if (tests > left) return height;
        left -= tests;
    }
    return 0;
}

/// How the queries are made.
struct QueryMethod {
    TuneSetting setting;
    const PackedLayout* layout = nullptr;  ///< null: not packed
};

/// A mesh with its hierarchy, and what queries of it need besides.
struct HeldMesh {
    Mesh mesh;
    AnyHierarchy hierarchy;
    std::optional<AnyPacked> packed{};
    std::vector<std::uint32_t> joined{};  ///< in a self query
};

/// Up to three digits, for commands. Halves of the longest side must not be longer.
double rounded_up(double value) {
    const CLocale with_points;
    return std::strtod(format("%.3g", 1.006 * value).c_str(), nullptr);
}

bool saves_percent(std::uint64_t percent, const Work& before, const Work& after) {
    return 100 * after.picoseconds <= (100 - percent) * before.picoseconds;
}

/// The recommended layout or setting, and its work in all frames.
std::pair<QueryMethod, Work> advised(const SceneTuning& tuning) {
    if (const TuneLayout* const layout = tuning.cheapest_layout())
        return {{tuning.rows[layout->row].setting, &layout->layout},
                {layout->n_v, layout->n_p, 0, layout->picoseconds}};
    const TuneRow& row = tuning.rows[tuning.recommended()];
    return {{row.setting}, row.counts};
}

/// Queries of two bodies whose meshes can be cut.
class Trial {
  public:
    Trial(const scenes::Scene& scene, std::size_t a, std::size_t b, const SceneTuning& tuning,
          const QueryMethod& method, const TuneProgress& progress)
        : is_self_(a == b),
          one_mesh_(scene.bodies[a].mesh == scene.bodies[b].mesh),
          build_(tuning.build),
          method_(method),
          progress_(progress) {
        for (const int frame : tuning.frames)
            poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                           scenes::pose_at(scene.bodies[b].motion, frame)));
        const std::size_t step = (poses_.size() + most_trial_frames - 1) / most_trial_frames;
        for (std::size_t i = 0; i < poses_.size(); i += step) few_.push_back(poses_[i]);
        place(0, scene.meshes[scene.bodies[a].mesh].mesh);
        if (!one_mesh_) place(1, scene.meshes[scene.bodies[b].mesh].mesh);
        before_ = after_ = work_of_queries(few_);
    }

    /// Cuts a mesh if that lowers the cost. `usual`: the height of tested triangles.
    void cut(std::size_t side, const std::vector<std::uint32_t>& costly, double usual) {
        const std::shared_ptr<const HeldMesh> whole = sides_[side];
        std::vector<std::uint32_t> seeds;
        if (costly.size() <= most_seeds) seeds = costly;
        double longest = longest_side(whole->mesh, costly) / 2;
        bool found = false;
        for (int worse = 0; worse < 4 && longest > usual; longest /= 2) {
            const double limit = rounded_up(longest);
            std::optional<CutMesh> cut = cut_triangles(whole->mesh, seeds, limit, most_pieces);
            if (!cut || progress_.ends()) return;
            const auto uncut = sides_;
            place(side, std::move(cut->mesh));
            const Work work = work_of_queries(few_);
            // A mesh is cut for a twentieth of the cost at least.
            const std::uint64_t least = found ? after_.picoseconds : after_.picoseconds / 20 * 19;
            if (work.picoseconds >= least) {
                sides_ = uncut;
                ++worse;
                continue;
            }
            if (found) cuts_.pop_back();
            cuts_.push_back({side, seeds, limit, cut->cut, cut->pieces});
            after_ = work;
            found = true;
            worse = 0;
        }
    }

    bool has_gained() const { return saves_percent(least_gain, before_, after_); }
    const std::vector<MeshCut>& cuts() const { return cuts_; }

    /// The work of the queries in all frames, by any method.
    Work work_by(const QueryMethod& method) {
        method_ = method;
        for (std::size_t side = 0; side < (one_mesh_ ? 1 : 2); ++side)
            place(side, Mesh(sides_[side]->mesh));
        return work_of_queries(poses_);
    }

  private:
    void place(std::size_t side, Mesh mesh) {
        BuildOptions options = build_;
        options.split = method_.setting.split;
        options.fit.growth = method_.setting.growth;
        AnyHierarchy hierarchy =
            std::move(build_hierarchies(mesh, std::array{method_.setting.volume}, options).front());
        const auto held =
            std::make_shared<HeldMesh>(HeldMesh{std::move(mesh), std::move(hierarchy)});
        if (method_.layout)
            held->packed =
                pack_any(*method_.layout, held->hierarchy, held->mesh, "mesh", options.threads);
        if (is_self_) held->joined = joined_vertices(held->mesh);
        sides_[side] = held;
        if (one_mesh_) sides_[1] = held;
    }

    Work work_of_queries(const std::vector<Pose>& poses) const {
        std::vector<Work> works(poses.size());
        parallel_for(build_.threads, works.size(), [&](std::size_t i) {
            if (!progress_.ends()) works[i] = work_of_query(poses[i]);
        });
        Work sum;
        for (const Work& work : works) sum += work;
        return sum;
    }

    Work work_of_query(const Pose& b_to_a) const {
        const HeldMesh &a = *sides_[0], &b = *sides_[1];
        const TuneSetting& setting = method_.setting;
        if (method_.layout) {
            const Collision found =
                collision_of(collide_packed(*a.packed, a.mesh, *b.packed, b.mesh, b_to_a));
            return {found.n_v, found.n_p, 0, layout_time(setting.volume, *method_.layout, found)};
        }
        CollideOptions options;
        options.overlap = setting.overlap;
        options.descent = setting.descent;
        return work_of(setting.volume, setting.overlap, setting.descent,
                       is_self_
                           ? collide_self(a.hierarchy, a.mesh, a.joined, options)
                           : collide(a.hierarchy, a.mesh, b.hierarchy, b.mesh, b_to_a, options));
    }

    bool is_self_, one_mesh_;
    BuildOptions build_;
    QueryMethod method_;
    const TuneProgress& progress_;
    std::vector<Pose> poses_, few_;
    std::array<std::shared_ptr<const HeldMesh>, 2> sides_;
    std::vector<MeshCut> cuts_;
    Work before_, after_;  // in few frames
};

}  // namespace

std::optional<CutTrial> try_cuts(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                 const SceneTuning& tuning,
                                 const std::array<std::vector<TestedTriangle>, 2>& tested,
                                 const TuneProgress& progress) {
    std::array<std::vector<TestedTriangle>, 2> of_meshes = tested;
    if (a != b && scene.bodies[a].mesh == scene.bodies[b].mesh) {
        add_tests(of_meshes[0], tested[1]);
        of_meshes[1].clear();
    }
    const auto mesh = [&](std::size_t side) -> const Mesh& {
        return scene.meshes[scene.bodies[side == 0 ? a : b].mesh].mesh;
    };
    double usual = std::numeric_limits<double>::infinity();
    for (std::size_t side = 0; side < of_meshes.size(); ++side)
        if (!of_meshes[side].empty())
            usual = std::min(usual, usual_height(of_meshes[side], mesh(side)));
    std::array<std::vector<std::uint32_t>, 2> costly;
    for (std::size_t side = 0; side < of_meshes.size(); ++side) {
        costly[side] = costly_part(of_meshes[side], mesh(side));
        if (longest_side(mesh(side), costly[side]) < long_ratio * usual) costly[side].clear();
    }
    if (costly[0].empty() && costly[1].empty()) return std::nullopt;
    const auto [best, best_work] = advised(tuning);
    const QueryMethod base{tuning.base().setting};
    std::vector<QueryMethod> methods = {best};
    if (best.layout || tuning.recommended() != 0) methods.push_back(base);
    progress.begin("bodies cut", methods.size() * costly.size());
    for (const QueryMethod& method : methods) {
        Trial trial(scene, a, b, tuning, method, progress);
        for (std::size_t side = 0; side < costly.size(); ++side) {
            if (!costly[side].empty()) trial.cut(side, costly[side], usual);
            if (!progress.step()) return std::nullopt;
        }
        if (!trial.has_gained()) continue;
        CutTrial result{trial.cuts(), best_work, {}, tuning.base().counts, {}};
        result.after = trial.work_by(best);
        result.base_after = trial.work_by(base);
        if (progress.ends()) return std::nullopt;
        if (saves_percent(least_gain, result.before, result.after) ||
            saves_percent(least_gain_of_base, result.base_before, result.base_after))
            return result;
    }
    return std::nullopt;
}

}  // namespace scb::app
