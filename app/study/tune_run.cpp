#include "app/study/tune_run.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <numeric>

#include "app/study/layout_time.h"
#include "app/study/query_timing.h"
#include "app/study/tune_choice.h"
#include "app/study/tune_subject.h"
#include "core/analysis/assumed_time.h"
#include "core/base/parallel_for.h"
#include "core/base/statistics.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// Limit of volume and triangle tests of all timed queries: about ten seconds.
constexpr double most_timed_tests = 1e8;
/// This many tests of packed layouts take as long as one other test.
constexpr std::uint64_t packed_tests_per_test = 4;

class Run {
  public:
    Run(TuneSubject& subject, const TuneOptions& options, const TuneProgress& progress)
        : subject_(subject),
          threads_(options.build.threads),
          gives_up_(options.gives_up),
          packs_(!options.layouts.empty()),
          progress_(progress),
          most_(subject.frames()) {}

    std::vector<TuneRow> rows;
    std::vector<TuneLayout> layouts;

    std::size_t given_up() const { return given_up_.size(); }
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

    /// Adds rows for settings that have none.
    bool count(const std::vector<TuneSetting>& settings) {
        const std::size_t old = rows.size();
        for (const TuneSetting& setting : settings)
            if (std::none_of(rows.begin(), rows.end(),
                             [&](const TuneRow& row) { return row.setting == setting; }) &&
                std::find(given_up_.begin(), given_up_.end(), setting) == given_up_.end())
                rows.emplace_back().setting = setting;
        pairs_.resize(rows.size(), std::vector<std::uint64_t>(subject_.frames()));
        progress_.begin("settings counted", rows.size() - old);
        std::vector<bool> done(rows.size()), kept(rows.size(), true);
        // Each hierarchy is built once, and only one set of them exists at a time.
        for (std::size_t first = old; first < rows.size(); ++first) {
            if (done[first]) continue;
            if (is_hopeless(rows[first].setting)) {
                kept[first] = false;
                if (!progress_.step()) return false;
                continue;
            }
            const BuiltSetting built = subject_.build(rows[first].setting);
            for (std::size_t r = first; r < rows.size(); ++r) {
                if (done[r] || !same_hierarchies(rows[r].setting, built.setting)) continue;
                kept[r] = count_row(r, built);
                done[r] = true;
                if (!progress_.step()) return false;
            }
        }
        remove_rows(kept);
        for (std::size_t r = 0; r < rows.size(); ++r) rows[r].misses_pairs = pairs_[r] != most_;
        return true;
    }

    /// Adds the layouts of the rows' hierarchies. Throws InputError if they cannot be packed.
    bool count_layouts(const std::vector<std::size_t>& packed,
                       const std::vector<PackedLayout>& tried) {
        progress_.begin("layouts counted", packed.size() * tried.size());
        for (const std::size_t r : packed) {
            const BuiltSetting built = subject_.build(rows[r].setting);
            for (const PackedLayout& layout : tried) {
                const BuiltLayout in_layout = subject_.pack(built, layout);
                TuneLayout& found = layouts.emplace_back();
                found.row = r;
                found.layout = layout;
                for (std::size_t i = 0; i < subject_.frames() && !progress_.ends(); ++i) {
                    const PackedCollision at = subject_.query(in_layout, i);
                    found.n_v += at.n_v;
                    found.n_p += at.n_p;
                    found.n_exact += at.n_exact;
                    found.n_after_doubles += at.n_after_doubles;
                    found.pairs += at.pairs.size();
                    if (layout.leaf_triangles == most_leaf_triangles)
                        found.picoseconds += layout_time(rows[r].setting.volume, layout, at.n_v,
                                                         at.n_p, at.pairs.size());
                    found.misses_pairs |= at.pairs.size() != pairs_[r][i];
                }
                found.bytes_per_triangle = subject_.bytes_per_triangle(in_layout);
                found.build_ms = in_layout.ms;
                if (!progress_.step()) return false;
            }
        }
        return true;
    }

    /// Times the rows and all layouts in these frames, in turns.
    bool time(const std::vector<std::size_t>& timed, const std::vector<std::size_t>& frames,
              int repeats) {
        std::vector<BuiltSetting> built;
        const auto built_of = [&](std::size_t r) {
            std::size_t k = 0;
            while (k < built.size() && !same_hierarchies(built[k].setting, rows[r].setting)) ++k;
            if (k == built.size()) built.push_back(subject_.build(rows[r].setting));
            return k;
        };
        std::vector<std::size_t> of_timed;
        for (const std::size_t r : timed) of_timed.push_back(built_of(r));
        std::vector<BuiltLayout> packed;
        for (const TuneLayout& layout : layouts)
            packed.push_back(subject_.pack(built[built_of(layout.row)], layout.layout));
        QueryTiming timing;
        timing.subjects = timed.size() + packed.size();
        timing.frames = frames.size();
        timing.before = [&](std::size_t s, std::size_t i) {
            if (s < timed.size())
                subject_.prepare(built[of_timed[s]], frames[i]);
            else
                subject_.prepare(packed[s - timed.size()], frames[i]);
        };
        timing.query = [&](std::size_t s, std::size_t i) {
            return QueryAnswer{
                s < timed.size()
                    ? subject_.query(built[of_timed[s]], rows[timed[s]].setting, frames[i])
                    : collision_of(subject_.query(packed[s - timed.size()], frames[i]))};
        };
        timing.step = progress_.step;
        progress_.begin("settings timed",
                        timing.subjects * frames.size() * static_cast<std::size_t>(repeats));
        std::vector<std::vector<double>> runs(timing.subjects);
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const auto ms = time_queries(timing);
            if (!ms) return false;
            for (std::size_t s = 0; s < runs.size(); ++s) runs[s].push_back(mean((*ms)[s]));
        }
        for (std::size_t s = 0; s < runs.size(); ++s)
            (s < timed.size() ? rows[timed[s]].ms : layouts[s - timed.size()].ms) =
                time_interval(std::move(runs[s]));
        return true;
    }

  private:
    /// Whether layouts need the row, however much its own queries cost.
    bool is_packed(const TuneSetting& setting) const {
        const TuneSetting usual;
        return packs_ && can_pack(setting.volume) && setting.overlap.test == usual.overlap.test &&
               setting.descent == usual.descent && setting.growth == usual.growth;
    }

    /// Whether a k-DOP would cost too much with half of the tests of the tightest volumes so far,
    /// in trees of the same split. Then its hierarchies are not built. Tight volumes with cheap
    /// tests are tried before.
    bool is_hopeless(const TuneSetting& setting) const {
        const auto& fewest = fewest_tests_[setting.split == SplitMethod::cost ? 1 : 0];
        const bool is_dop = setting.volume == VolumeKind::dop14 ||
                            setting.volume == VolumeKind::dop18 ||
                            setting.volume == VolumeKind::dop26;
        return is_dop && fewest &&
               least_test_time(setting.volume, setting.overlap.test) * (*fewest / 2) >
                   hopeless_cost * *least_cost_;
    }

    /// False if the setting is given up. Which ones are does not depend on the order in which
    /// frames are counted: the cost of some frames is at most the cost of all.
    bool count_row(std::size_t r, const BuiltSetting& built) {
        TuneRow& row = rows[r];
        std::vector<Work> counts(subject_.frames());
        std::atomic<std::uint64_t> cost{0};
        const auto is_hopeless = [&] {
            return r != 0 && least_cost_ && cost > hopeless_cost * *least_cost_ &&
                   !is_packed(row.setting);
        };
        parallel_for(threads_, subject_.frames(), [&](std::size_t i) {
            if (progress_.ends() || is_hopeless()) return;
            const Collision found = subject_.query(built, row.setting, i);
            counts[i] =
                work_of(row.setting.volume, row.setting.overlap, row.setting.descent, found);
            pairs_[r][i] = found.pairs.size();
            cost += counts[i].picoseconds;
        });
        if (is_hopeless()) return false;
        // A test that misses pairs may end early, and cost little.
        for (std::size_t i = 0; i < counts.size(); ++i) {
            row.counts += counts[i];
            row.pairs += pairs_[r][i];
            most_[i] = std::max(most_[i], pairs_[r][i]);
        }
        if (gives_up_ && is_sound(row.setting.overlap.test)) {
            least_cost_ = std::min(least_cost_.value_or(cost), cost.load());
            auto& fewest = fewest_tests_[row.setting.split == SplitMethod::cost ? 1 : 0];
            fewest = std::min(fewest.value_or(row.counts.volume_tests), row.counts.volume_tests);
        }
        row.bytes_per_triangle = subject_.bytes_per_triangle(built);
        row.build_ms = built.ms;
        return true;
    }

    void remove_rows(const std::vector<bool>& kept) {
        std::size_t left = 0;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (!kept[r]) {
                given_up_.push_back(rows[r].setting);
                continue;
            }
            if (left != r) {
                rows[left] = std::move(rows[r]);
                pairs_[left] = std::move(pairs_[r]);
            }
            ++left;
        }
        rows.resize(left);
        pairs_.resize(left);
    }

    TuneSubject& subject_;
    int threads_;
    bool gives_up_, packs_;
    std::vector<TuneSetting> given_up_;
    const TuneProgress& progress_;
    std::optional<std::uint64_t> least_cost_;  // of a row, if settings are given up
    // Then also of a row of each split.
    std::array<std::optional<std::uint64_t>, 2> fewest_tests_;
    std::vector<std::vector<std::uint64_t>> pairs_;  // per row, per frame
    std::vector<std::uint64_t> most_;                // pairs per frame
};

/// The number of tests if the rows and layouts are timed in all frames. Each timed query follows an
/// untimed one over its nodes.
double timed_tests(const SceneTuning& tuning, const std::vector<std::size_t>& timed, int repeats) {
    std::uint64_t tests = 0;
    for (const std::size_t r : timed)
        tests += tuning.rows[r].counts.volume_tests + tuning.rows[r].counts.triangle_tests;
    for (const TuneLayout& layout : tuning.layouts)
        tests += (layout.n_v + layout.n_p) / packed_tests_per_test;
    return 2.0 * repeats * static_cast<double>(tests);
}

/// Indices of evenly spread frames: all, or so few that they need about `most` of all `tests`
/// tests.
std::vector<std::size_t> affordable_frames(std::size_t frames, double tests, double most) {
    const auto step = static_cast<std::size_t>(
        std::ceil(std::clamp(tests / most, 1.0, static_cast<double>(frames))));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < frames; i += step) places.push_back(i);
    return places;
}

}  // namespace

std::vector<PackedLayout> tried_layouts() {
    std::vector<PackedLayout> tried;
    for (const PackedLayout& layout : all_packed_layouts()) {
        tried.push_back(layout);
        if (layout.width != QuickestCodec::width || layout.corners != LeafCorners::stored ||
            layout.numbers != PackedLayout::Numbers::quantized)
            continue;
        for (const int leaf_triangles : {3, 2, 1}) {
            tried.push_back(layout);
            tried.back().leaf_triangles = leaf_triangles;
        }
    }
    return tried;
}

std::vector<PackedLayout> widest_layouts() {
    std::vector<PackedLayout> widest;
    for (const PackedLayout& layout : all_packed_layouts())
        if (layout.width == QuickestCodec::width) widest.push_back(layout);
    return widest;
}

std::vector<std::size_t> counted_frames(std::size_t frames, const Work& all) {
    constexpr double most_tests = 3e7, usual_settings = 50;
    return affordable_frames(
        frames, usual_settings * static_cast<double>(all.volume_tests + all.triangle_tests),
        most_tests);
}

std::vector<std::size_t> SceneTuning::listed(std::size_t most) const {
    std::vector<std::size_t> places;
    const auto but_for_growth = [&](std::size_t r) {
        TuneSetting setting = rows[r].setting;
        setting.growth = base().setting.growth;
        return setting;
    };
    for (const std::size_t r : best) {
        const bool alike = std::any_of(places.begin(), places.end(), [&](std::size_t better) {
            return but_for_growth(better) == but_for_growth(r);
        });
        if (r != 0 && (r == recommended() || (places.size() < most && !alike))) places.push_back(r);
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
    TuneSubject subject(scene, a, b, frames, options.build);
    Run run(subject, options, progress);
    if (!run.count(first_trials(options.base, !options.gives_up))) return std::nullopt;
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
        refine(settings_to_refine(first, run.counts(), !options.gives_up));
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
    result.given_up = run.given_up();
    result.best = best_rows(run.rows, run.counts());
    assert(!result.best.empty() && "the first setting that misses no pairs is never given up");
    const auto fewest_of = [&](std::uint64_t Work::*count) {
        return *std::min_element(
            result.best.begin(), result.best.end(), [&](std::size_t x, std::size_t y) {
                return result.rows[x].counts.*count < result.rows[y].counts.*count;
            });
    };
    if (!options.gives_up) {
        result.fewest_tests = fewest_of(&Work::volume_tests);
        result.fewest_operations = fewest_of(&Work::operations);
    }
    if (!options.layouts.empty()) {
        try {
            if (!run.count_layouts(packed_rows(result), options.layouts)) return std::nullopt;
        } catch (const InputError& error) {
            run.layouts.clear();
            result.no_layouts = std::string("No packed layout was tried: ") + error.what();
        }
        result.layouts = run.layouts;
    }
    if (options.repeats > 0) {
        const std::vector<std::size_t> timed = timed_rows(result),
                                       places = affordable_frames(
                                           frames.size(),
                                           timed_tests(result, timed, options.repeats),
                                           most_timed_tests);
        if (!run.time(timed, places, options.repeats)) return std::nullopt;
        for (const std::size_t i : places) result.timed_frames.push_back(frames[i]);
        result.runs = options.repeats;
        result.rows = std::move(run.rows);
        result.layouts = std::move(run.layouts);
        result.least_time = least_time_of(result.rows, result.best);
        result.quicker_layout = quicker_layout_of(result);
    } else {
        result.quicker_layout = cheaper_layout_of(result);
    }
    return result;
}

}  // namespace scb::app
