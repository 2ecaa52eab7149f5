#include "app/timing/tune_run.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/timing/query_timing.h"
#include "core/analysis/operation_cost.h"
#include "core/base/parallel_for.h"
#include "core/base/statistics.h"

namespace scb::app {
namespace {

/// Volume tests and triangle tests of all timed queries: some ten seconds.
constexpr double most_timed_tests = 1e8;

double process_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The hierarchies of a setting, one per mesh.
struct BuiltSetting {
    TuneSetting setting;
    std::vector<AnyHierarchy> hierarchies;
    double ms = 0;
};

/// The scene, and what queries of it need.
class Subject {
  public:
    Subject(const scenes::Scene& scene, std::size_t a, std::size_t b,
            const std::vector<int>& frames, const BuildOptions& build)
        : scene_(scene),
          build_(build),
          mesh_a_(scene.bodies[a].mesh),
          mesh_b_(scene.bodies[b].mesh) {
        for (const int frame : frames)
            poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                           scenes::pose_at(scene.bodies[b].motion, frame)));
    }

    std::size_t frames() const { return poses_.size(); }

    BuiltSetting build(const TuneSetting& setting) {
        BuildOptions options = build_;
        options.split = setting.split;
        options.fit.growth = setting.growth;
        Split* split = &splits_[setting.split == SplitMethod::cost ? 1 : 0];
        if (split->topologies.empty()) {
            const double start = process_milliseconds();
            split->topologies = scenes::build_topologies(scene_, options.topology());
            split->ms = process_milliseconds() - start;
        }
        BuiltSetting built{setting, {}, 0};
        const double start = process_milliseconds();
        built.hierarchies = scenes::fit_meshes(split->topologies, setting.volume, options);
        built.ms = split->ms + process_milliseconds() - start;
        return built;
    }

    double bytes_per_triangle(const BuiltSetting& built) const {
        std::size_t bytes = 0, triangles = 0;
        for (const std::size_t m : {mesh_a_, mesh_b_}) {
            bytes += bytes_of(built.hierarchies[m]);
            triangles += scene_.meshes[m].mesh.triangles.size();
        }
        return ratio(static_cast<double>(bytes), static_cast<double>(triangles));
    }

    Collision query(const BuiltSetting& built, const TuneSetting& setting,
                    std::size_t frame) const {
        CollideOptions options;
        options.overlap = setting.overlap;
        options.descent = setting.descent;
        return collide(built.hierarchies[mesh_a_], scene_.meshes[mesh_a_].mesh,
                       built.hierarchies[mesh_b_], scene_.meshes[mesh_b_].mesh, poses_[frame],
                       options);
    }

    /// What makes a timed query independent of the one before it. Settings are so much alike that
    /// one is quicker right after another with the same hierarchies, which are in the caches then,
    /// or the same overlap test, whose branches it repeats. So before each its nodes are brought
    /// into the caches by a query with the slowest test, A and B exchanged.
    void prepare(const BuiltSetting& built, std::size_t frame) const {
        CollideOptions slow;
        slow.overlap.test = OverlapTest::extents;
        collide(built.hierarchies[mesh_b_], scene_.meshes[mesh_b_].mesh, built.hierarchies[mesh_a_],
                scene_.meshes[mesh_a_].mesh, relative_pose(poses_[frame], Pose{}), slow);
    }

  private:
    struct Split {
        std::vector<MeshTopology> topologies;
        double ms = 0;
    };

    const scenes::Scene& scene_;
    BuildOptions build_;
    std::size_t mesh_a_, mesh_b_;
    Split splits_[2];
    std::vector<Pose> poses_;  // per frame
};

class Run {
  public:
    Run(Subject& subject, int threads, const TuneProgress& progress)
        : subject_(subject), threads_(threads), progress_(progress), most_(subject.frames()) {}

    std::vector<TuneRow> rows;

    std::vector<TuneSetting> settings() const {
        std::vector<TuneSetting> result;
        for (const TuneRow& row : rows) result.push_back(row.setting);
        return result;
    }
    std::vector<Work> counts() const {
        std::vector<Work> result;
        for (const TuneRow& row : rows) result.push_back(row.counts);
        return result;
    }

    /// Adds rows of the settings that have none.
    bool count(const std::vector<TuneSetting>& settings) {
        const std::size_t old = rows.size();
        for (const TuneSetting& setting : settings)
            if (std::none_of(rows.begin(), rows.end(),
                             [&](const TuneRow& row) { return row.setting == setting; }))
                rows.emplace_back().setting = setting;
        pairs_.resize(rows.size(), std::vector<std::uint64_t>(subject_.frames()));
        progress_.begin("settings counted", rows.size() - old);
        std::vector<bool> done(rows.size());
        // Hierarchies are built once, and never those of all settings at a time.
        for (std::size_t first = old; first < rows.size(); ++first) {
            if (done[first]) continue;
            const BuiltSetting built = subject_.build(rows[first].setting);
            for (std::size_t r = first; r < rows.size(); ++r) {
                if (done[r] || !same_hierarchies(rows[r].setting, built.setting)) continue;
                count_row(r, built);
                done[r] = true;
                if (!progress_.step()) return false;
            }
        }
        for (std::size_t r = 0; r < rows.size(); ++r) rows[r].misses_pairs = pairs_[r] != most_;
        return true;
    }

    /// Times the rows in some of the frames, in turns.
    bool time(const std::vector<std::size_t>& timed, const std::vector<std::size_t>& frames,
              int repeats) {
        std::vector<BuiltSetting> built;
        std::vector<std::size_t> built_of;
        for (const std::size_t r : timed) {
            std::size_t k = 0;
            while (k < built.size() && !same_hierarchies(built[k].setting, rows[r].setting)) ++k;
            if (k == built.size()) built.push_back(subject_.build(rows[r].setting));
            built_of.push_back(k);
        }
        QueryTiming timing;
        timing.subjects = timed.size();
        timing.frames = frames.size();
        timing.before = [&](std::size_t s, std::size_t i) {
            subject_.prepare(built[built_of[s]], frames[i]);
        };
        timing.query = [&](std::size_t s, std::size_t i) {
            return subject_.query(built[built_of[s]], rows[timed[s]].setting, frames[i]);
        };
        timing.step = progress_.step;
        progress_.begin("settings timed",
                        timed.size() * frames.size() * static_cast<std::size_t>(repeats));
        std::vector<std::vector<double>> runs(timed.size());
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const auto ms = time_queries(timing);
            if (!ms) return false;
            for (std::size_t s = 0; s < timed.size(); ++s) runs[s].push_back(mean((*ms)[s]));
        }
        for (std::size_t s = 0; s < timed.size(); ++s)
            rows[timed[s]].ms = time_interval(std::move(runs[s]));
        return true;
    }

  private:
    void count_row(std::size_t r, const BuiltSetting& built) {
        TuneRow& row = rows[r];
        std::vector<Work> counts(subject_.frames());
        parallel_for(threads_, subject_.frames(), [&](std::size_t i) {
            const Collision found = subject_.query(built, row.setting, i);
            counts[i] = {found.n_v, found.n_p,
                         operation_count(row.setting.volume, row.setting.overlap, found.stages)};
            pairs_[r][i] = found.pairs.size();
        });
        for (std::size_t i = 0; i < counts.size(); ++i) {
            row.counts += counts[i];
            row.pairs += pairs_[r][i];
            most_[i] = std::max(most_[i], pairs_[r][i]);
        }
        row.bytes_per_triangle = subject_.bytes_per_triangle(built);
        row.build_ms = built.ms;
    }

    Subject& subject_;
    int threads_;
    const TuneProgress& progress_;
    std::vector<std::vector<std::uint64_t>> pairs_;  // per row, per frame
    std::vector<std::uint64_t> most_;                // pairs per frame
};

/// The rows that may be recommended, the best first: no row that misses pairs, and of equal ones
/// the first.
std::vector<std::size_t> best_rows(const std::vector<TuneRow>& all,
                                   const std::vector<Work>& counts) {
    std::vector<std::size_t> best;
    for (const std::size_t r : best_first(counts))
        if (is_sound(all[r].setting.overlap.test) && !all[r].misses_pairs &&
            (best.empty() || counts[best.back()] != counts[r]))
            best.push_back(r);
    return best;
}

/// The row that no other is measurably quicker than: of those whose intervals meet that of the
/// least median the base, or else the one with the fewest tests.
std::size_t least_time_of(const std::vector<TuneRow>& all, const std::vector<std::size_t>& best) {
    const TuneRow* least = nullptr;
    for (const std::size_t r : best)
        if (all[r].ms && (least == nullptr || all[r].ms->median < least->ms->median))
            least = &all[r];
    const auto is_least = [&](std::size_t r) {
        return all[r].ms && !apart(*all[r].ms, *least->ms);
    };
    if (std::find(best.begin(), best.end(), 0u) != best.end() && is_least(0)) return 0;
    return *std::find_if(best.begin(), best.end(), is_least);
}

/// What is timed: the base, also with the other split, the rows with the fewest tests, the best of
/// each volume, the one with the fewest operations.
std::vector<std::size_t> timed_rows(const SceneTuning& tuning) {
    std::vector<std::size_t> timed = {0};
    const auto add = [&](std::size_t r) {
        if (std::find(timed.begin(), timed.end(), r) == timed.end()) timed.push_back(r);
    };
    add(tuning.best[0]);
    for (const std::size_t r : tuning.listed(most_timed)) add(r);
    for (std::size_t r = 0; r < tuning.rows.size(); ++r)
        if (tuned(tuning.rows[r].setting, tuning.base().setting) == Tuned::split) add(r);
    add(tuning.fewest_operations);
    for (const VolumeKind kind : all_volume_kinds()) {
        const auto of_kind =
            std::find_if(tuning.best.begin(), tuning.best.end(),
                         [&](std::size_t r) { return tuning.rows[r].setting.volume == kind; });
        if (of_kind != tuning.best.end()) add(*of_kind);
    }
    return timed;
}

/// The tests that timing the rows in all frames takes, each query after another of its nodes.
double timed_tests(const SceneTuning& tuning, const std::vector<std::size_t>& timed, int repeats) {
    Work work;
    for (const std::size_t r : timed) work += tuning.rows[r].counts;
    return 2.0 * repeats * static_cast<double>(work.volume_tests + work.triangle_tests);
}

}  // namespace

std::vector<std::size_t> affordable_frames(std::size_t frames, double tests, double most) {
    const auto step = static_cast<std::size_t>(
        std::ceil(std::clamp(tests / most, 1.0, static_cast<double>(frames))));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < frames; i += step) places.push_back(i);
    return places;
}

std::vector<std::size_t> SceneTuning::listed(std::size_t most) const {
    std::vector<std::size_t> places;
    const auto but_for_growth = [&](std::size_t r) {
        TuneSetting setting = rows[r].setting;
        setting.growth = base().setting.growth;
        return setting;
    };
    for (const std::size_t r : best) {
        if (places.size() == most) break;
        const bool alike = std::any_of(places.begin(), places.end(), [&](std::size_t better) {
            return but_for_growth(better) == but_for_growth(r);
        });
        if (r != 0 && !alike) places.push_back(r);
    }
    return places;
}

std::size_t SceneTuning::equals(std::size_t row) const {
    std::size_t equal = 0;
    for (const TuneRow& other : rows)
        equal += other.counts == rows[row].counts && other.pairs == rows[row].pairs;
    return equal - 1;
}

std::optional<SceneTuning> tune_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const TuneOptions& options,
                                      const TuneProgress& progress) {
    Subject subject(scene, a, b, frames, options.build);
    Run run(subject, options.build.threads, progress);
    if (!run.count(first_trials(options.base))) return std::nullopt;
    const std::vector<TuneSetting> first = run.settings();
    std::vector<TuneSetting> refined;
    const auto refine = [&](const std::vector<std::size_t>& places) {
        for (const std::size_t i : places)
            for (const TuneSetting& setting : refined_trials(first[i])) refined.push_back(setting);
    };
    if (options.every) {
        std::vector<std::size_t> all(first.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        refine(all);
    } else {
        refine(worth_refining_of(first, run.counts()));
    }
    if (!run.count(refined)) return std::nullopt;

    SceneTuning result;
    result.scene = scene.name;
    result.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    for (const std::size_t body : {a, b})
        result.triangles.push_back(scene.meshes[scene.bodies[body].mesh].mesh.triangles.size());
    result.frames = frames;
    result.build = options.build;
    result.build.fit.growth = FitOptions{}.growth;  // each setting has its own
    result.build.split = BuildOptions{}.split;
    result.rows = run.rows;
    result.best = best_rows(run.rows, run.counts());
    result.fewest_operations = *std::min_element(
        result.best.begin(), result.best.end(), [&](std::size_t x, std::size_t y) {
            return result.rows[x].counts.operations < result.rows[y].counts.operations;
        });
    if (options.repeats > 0) {
        const std::vector<std::size_t> timed = timed_rows(result),
                                       places = affordable_frames(
                                           frames.size(),
                                           timed_tests(result, timed, options.repeats),
                                           most_timed_tests);
        if (!run.time(timed, places, options.repeats)) return std::nullopt;
        for (const std::size_t i : places) result.timed_frames.push_back(frames[i]);
        result.rows = std::move(run.rows);
        result.least_time = least_time_of(result.rows, result.best);
    }
    return result;
}

}  // namespace scb::app
