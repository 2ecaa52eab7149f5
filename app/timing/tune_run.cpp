#include "app/timing/tune_run.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/timing/query_timing.h"
#include "core/analysis/operation_cost.h"
#include "core/base/statistics.h"

namespace scb::app {
namespace {

/// The scene with a hierarchy per mesh and growth rule that matters.
class Subject {
  public:
    Subject(const scenes::Scene& scene, std::size_t a, std::size_t b,
            const std::vector<int>& frames, VolumeKind kind, BuildOptions build)
        : scene_(scene), mesh_a_(scene.bodies[a].mesh), mesh_b_(scene.bodies[b].mesh) {
        const std::vector<MeshTopology> topologies =
            scenes::build_topologies(scene, build.topology());
        for (const BallGrowth growth : growths) {
            build.fit.growth = growth;
            hierarchies_.push_back(scenes::fit_meshes(topologies, kind, build));
            if (!has_growth(kind)) break;
        }
        for (const int frame : frames)
            poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                           scenes::pose_at(scene.bodies[b].motion, frame)));
    }

    std::size_t frames() const { return poses_.size(); }

    Collision query(const TuneSetting& setting, std::size_t frame) const {
        CollideOptions options;
        options.overlap = setting.overlap;
        options.descent = setting.descent;
        return collide(of(setting)[mesh_a_], scene_.meshes[mesh_a_].mesh, of(setting)[mesh_b_],
                       scene_.meshes[mesh_b_].mesh, poses_[frame], options);
    }

    /// What makes a timed query independent of the one before it. Settings are so much alike that
    /// one is quicker right after another with the same hierarchies, which are in the caches then,
    /// or the same overlap test, whose branches it repeats. So before each its nodes are brought
    /// into the caches by a query with the slowest test, A and B exchanged.
    void prepare(const TuneSetting& setting, std::size_t frame) const {
        CollideOptions slow;
        slow.overlap.test = OverlapTest::extents;
        collide(of(setting)[mesh_b_], scene_.meshes[mesh_b_].mesh, of(setting)[mesh_a_],
                scene_.meshes[mesh_a_].mesh, relative_pose(poses_[frame], Pose{}), slow);
    }

  private:
    const std::vector<AnyHierarchy>& of(const TuneSetting& setting) const {
        return hierarchies_[setting.growth == growths[0] ? 0 : 1];
    }

    static constexpr BallGrowth growths[] = {BallGrowth::ritter, BallGrowth::radius};

    const scenes::Scene& scene_;
    std::size_t mesh_a_, mesh_b_;
    std::vector<std::vector<AnyHierarchy>> hierarchies_;  // per growth, per mesh
    std::vector<Pose> poses_;                             // per frame
};

/// 0 to count - 1, neighbors far from each other: those among the thresholds are the most alike.
std::vector<std::size_t> spread_order(std::size_t count) {
    std::size_t stride = count * 3 / 8 + 1;
    while (std::gcd(stride, count) != 1) ++stride;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < count; ++i) order.push_back(i * stride % count);
    return order;
}

class Run {
  public:
    Run(const Subject& subject, VolumeKind kind, const TuneProgress& progress)
        : subject_(subject), kind_(kind), progress_(progress), most_pairs_(subject.frames()) {}

    std::vector<TuneRow> rows;

    std::vector<TuneTrial> trials() const {
        std::vector<TuneTrial> result;
        for (const TuneRow& row : rows) result.push_back(row.trial);
        return result;
    }
    std::vector<double> column(double TuneRow::*value) const {
        std::vector<double> result;
        for (const TuneRow& row : rows) result.push_back(row.*value);
        return result;
    }

    /// Adds rows with their counts.
    bool count(const std::vector<TuneTrial>& trials) {
        progress_.begin("settings counted", trials.size() * subject_.frames());
        for (const TuneTrial& trial : trials) {
            std::vector<std::uint64_t> n_v, n_p, operations, pairs;
            for (std::size_t i = 0; i < subject_.frames(); ++i) {
                const Collision found = subject_.query(trial.setting, i);
                n_v.push_back(found.n_v);
                n_p.push_back(found.n_p);
                operations.push_back(operation_count(kind_, trial.setting.overlap, found.stages));
                pairs.push_back(found.pairs.size());
                if (!progress_.step()) return false;
            }
            rows.push_back({trial, mean(n_v), mean(n_p), mean(operations), mean(pairs), false,
                            std::numeric_limits<double>::quiet_NaN()});
            pairs_.push_back(pairs);
            for (std::size_t i = 0; i < pairs.size(); ++i)
                most_pairs_[i] = std::max(most_pairs_[i], pairs[i]);
        }
        for (std::size_t r = 0; r < rows.size(); ++r)
            rows[r].misses_pairs = pairs_[r] != most_pairs_;
        return true;
    }

    /// Times all rows, in turns.
    bool time(int repeats) {
        if (repeats == 0) return true;
        const std::vector<std::size_t> order = spread_order(rows.size());
        QueryTiming timing;
        timing.subjects = rows.size();
        timing.frames = subject_.frames();
        timing.repeats = repeats;
        timing.before = [&](std::size_t s, std::size_t i) {
            subject_.prepare(rows[order[s]].trial.setting, i);
        };
        timing.query = [&](std::size_t s, std::size_t i) {
            return subject_.query(rows[order[s]].trial.setting, i);
        };
        timing.step = progress_.step;
        progress_.begin("settings timed",
                        rows.size() * subject_.frames() * static_cast<std::size_t>(repeats));
        const auto ms = time_queries(timing);
        if (!ms) return false;
        for (std::size_t s = 0; s < rows.size(); ++s) rows[order[s]].ms = mean((*ms)[s]);
        return true;
    }

  private:
    const Subject& subject_;
    VolumeKind kind_;
    const TuneProgress& progress_;
    std::vector<std::vector<std::uint64_t>> pairs_;  // per row, per frame
    std::vector<std::uint64_t> most_pairs_;          // per frame
};

}  // namespace

std::optional<SceneTuning> tune_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const TuneOptions& options,
                                      const TuneProgress& progress) {
    const Subject subject(scene, a, b, frames, options.kind, options.build);
    Run run(subject, options.kind, progress);
    const bool timed = options.repeats > 0;
    if (!run.count(tune_trials(options.base, options.kind)) || !run.time(timed ? 1 : 0))
        return std::nullopt;

    std::vector<TuneTrial> together;
    const auto add_best = [&](double TuneRow::*cost, double least_gain) {
        const auto best = best_together(run.trials(), run.column(cost), least_gain);
        if (best && (together.empty() || !(together[0].setting == best->setting)))
            together.push_back(*best);
    };
    add_best(&TuneRow::operations, 0);
    if (timed) add_best(&TuneRow::ms, least_time_gain);
    if (!run.count(together) || !run.time(options.repeats)) return std::nullopt;

    SceneTuning result;
    result.scene = scene.name;
    result.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    for (const std::size_t body : {a, b})
        result.triangles.push_back(scene.meshes[scene.bodies[body].mesh].mesh.triangles.size());
    result.frames = frames;
    result.kind = options.kind;
    result.build = options.build;
    result.build.fit.growth = FitOptions{}.growth;  // each setting has its own
    result.timed = timed;
    result.fewest_operations = best_trial(run.trials(), run.column(&TuneRow::operations), 0);
    if (timed)
        result.least_time = best_trial(run.trials(), run.column(&TuneRow::ms), least_time_gain);
    result.rows = std::move(run.rows);
    return result;
}

}  // namespace scb::app
