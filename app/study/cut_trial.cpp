#include "app/study/cut_trial.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>

#include "core/base/text_format.h"
#include "core/geometry/mesh_cut.h"

namespace scb::app {
namespace {

/// More triangles are not cut by their numbers, but all that are as long.
constexpr std::size_t most_seeds = 64;
/// The costly triangles take at least four fifths of the triangle tests.
constexpr std::uint64_t tests_numerator = 4, tests_denominator = 5;
constexpr std::size_t most_pieces = 20'000;
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

/// Up to three digits, for commands. Halves of the longest side must not be longer.
double rounded_up(double value) {
    const CLocale with_points;
    return std::strtod(format("%.3g", 1.006 * value).c_str(), nullptr);
}

/// Cuts the meshes of a trial.
class CutSearch {
  public:
    CutSearch(MeshTrial& trial, const TuneProgress& progress)
        : trial_(trial),
          progress_(progress),
          before_(trial.work_in_few_frames()),
          after_(before_) {}

    /// Cuts a mesh if that lowers the cost. `usual`: the height of tested triangles.
    void cut(std::size_t side, const std::vector<std::uint32_t>& costly, double usual) {
        const std::shared_ptr<const TrialMesh> whole = trial_.sides()[side];
        std::vector<std::uint32_t> seeds;
        if (costly.size() <= most_seeds) seeds = costly;
        double longest = longest_side(whole->mesh, costly) / 2;
        bool found = false;
        for (int worse = 0; worse < 4 && longest > usual; longest /= 2) {
            const double limit = rounded_up(longest);
            std::optional<CutMesh> cut = cut_triangles(whole->mesh, seeds, limit, most_pieces);
            if (!cut || progress_.ends()) return;
            const MeshTrial::Sides uncut = trial_.sides();
            trial_.place(side, std::move(cut->mesh));
            const Work work = trial_.work_in_few_frames();
            // A mesh is cut for a twentieth of the cost at least.
            const std::uint64_t least = found ? after_.picoseconds : after_.picoseconds / 20 * 19;
            if (work.picoseconds >= least) {
                trial_.set_sides(uncut);
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

    bool has_gained() const { return saves_tenth(before_, after_); }
    const std::vector<MeshCut>& cuts() const { return cuts_; }

  private:
    MeshTrial& trial_;
    const TuneProgress& progress_;
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
    const QueryMethod base{tuning.base().setting, {}};
    std::vector<QueryMethod> methods = {best};
    if (best.layout || tuning.recommended() != 0) methods.push_back(base);
    progress.begin("bodies cut", methods.size() * costly.size());
    for (const QueryMethod& method : methods) {
        MeshTrial trial(scene, a, b, tuning, method, progress);
        CutSearch search(trial, progress);
        for (std::size_t side = 0; side < costly.size(); ++side) {
            if (!costly[side].empty()) search.cut(side, costly[side], usual);
            if (!progress.step()) return std::nullopt;
        }
        if (!search.has_gained()) continue;
        CutTrial result{search.cuts(), {best_work, {}, tuning.base().counts, {}}};
        result.work.after = trial.work_by(best);
        result.work.base_after = trial.work_by(base);
        if (progress.ends()) return std::nullopt;
        if (result.work.pays()) return result;
    }
    return std::nullopt;
}

}  // namespace scb::app
