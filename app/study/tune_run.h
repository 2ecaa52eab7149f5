#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/study/scene_query.h"
#include "core/analysis/tuning.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// The costs of one setting, over all frames.
struct TuneRow {
    TuneSetting setting;
    Work counts;
    std::uint64_t pairs = 0;
    bool misses_pairs = false;      ///< finds fewer in some frame than another setting
    double bytes_per_triangle = 0;  ///< of the hierarchies of both bodies, topology included
    double build_ms = 0;            ///< processor time of building the hierarchies
    std::optional<TimeInterval>
        ms;  ///< of a query, the mean over the timed frames; only for timed rows
};

/// The costs of a setting's hierarchies in a packed layout, over all frames. Layouts have their own
/// test and descent; wide nodes and large leaves change the counts.
struct TuneLayout {
    std::size_t row = 0;  ///< the row whose hierarchies are packed
    PackedLayout layout;
    std::uint64_t n_v = 0, n_p = 0, pairs = 0;
    std::uint64_t n_exact = 0, n_after_doubles = 0;  ///< see PackedCollision
    std::uint64_t picoseconds = 0;                   ///< see layout_time; 0 for smaller leaves
    bool misses_pairs = false;  ///< finds other pairs than the row, which is an error
    double bytes_per_triangle = 0;
    double build_ms = 0;  ///< of the row's hierarchies and of packing
    std::optional<TimeInterval> ms;
};

/// The settings of one scene, the base first.
struct SceneTuning {
    std::string scene;
    std::vector<std::string> bodies;     ///< names of A and B
    std::vector<std::size_t> triangles;  ///< of A and B
    std::vector<int> frames, timed_frames;
    BuildOptions build;  ///< without split and growth, which are tuned
    std::vector<TuneRow> rows;
    std::size_t given_up = 0;       ///< settings without a row, see TuneOptions::gives_up
    std::vector<std::size_t> best;  ///< rows that find all pairs, the least cost first;
                                    ///< of rows with equal counts only the first
    /// Rows in `best`; none if settings may be given up, which may have fewer.
    std::optional<std::size_t> fewest_tests, fewest_operations;
    int runs = 0;                     ///< of each timed query
    std::size_t least_time = 0;       ///< see least_time_of; 0 if nothing is timed
    std::vector<TuneLayout> layouts;  ///< of the row with the fewest tests of each packable volume
    std::string no_layouts;           ///< a sentence: why there are no layouts
    /// The index of a layout that is measurably quicker than `recommended`, if there is one. Of the
    /// layouts that no other is measurably quicker than, it is the one with the least memory.
    /// Without times, one of widest_layouts that costs less than `recommended`. Of the layouts that
    /// cost at most a tenth more than the least, it is the one with the least memory.
    std::optional<std::size_t> quicker_layout;

    double mean(std::uint64_t sum) const {
        return static_cast<double>(sum) / static_cast<double>(frames.size());
    }
    const TuneRow& base() const { return rows[0]; }
    /// The layout that costs less than every row; null with times, or if no layout does.
    const TuneLayout* cheapest_layout() const {
        return !timed() && quicker_layout ? &layouts[*quicker_layout] : nullptr;
    }
    /// At most `most` of the best rows, the best first, and the recommended one. Leaves out rows
    /// that differ from a better row only in the growth of balls. The base is not listed.
    std::vector<std::size_t> listed(std::size_t most) const;
    /// The number of other rows with the same counts.
    std::size_t equals(std::size_t row) const;
    bool timed() const { return rows[0].ms.has_value(); }
    /// The row to use: the one with the least time. Without times, the one with the least estimated
    /// cost, since tests of some volumes take a hundred times as long as others. Never a row that
    /// misses pairs.
    std::size_t recommended() const { return timed() ? least_time : best[0]; }
};

/// All layouts with large leaves; the usually quickest one also with smaller leaves.
std::vector<PackedLayout> tried_layouts();
/// The layouts of the widest nodes, which are mostly the quickest.
std::vector<PackedLayout> widest_layouts();

struct TuneOptions {
    TuneSetting base;  ///< overlap and growth keep their defaults if the volume does not use them
    BuildOptions build;
    bool every = false;                      ///< whether the settings of all volumes are tried
    int repeats = 0;                         ///< of each timed query; 0: nothing is timed
    std::vector<PackedLayout> layouts = {};  ///< that are tried, see tried_layouts
    /// Whether to try fewer settings: no other thresholds, and no variants of volumes that cost
    /// more than the best. A setting is given up if it costs more than `hopeless_cost` times the
    /// least that a setting before it costs, as soon as some of its frames show that; a k-DOP by
    /// the tests of other volumes. Settings whose test may miss pairs are no measure.
    bool gives_up = false;
};
inline constexpr std::uint64_t hopeless_cost = 3;

/// Indices of evenly spread frames in which tune_scene needs only seconds to count: all, or fewer.
/// `all`: the work of one setting's queries in all `frames` frames.
std::vector<std::size_t> counted_frames(std::size_t frames, const Work& all);

/// `begin` is called at the beginning of a part of the run, with its number of steps, and `step`
/// after each step. The run ends if `step` returns false. During long steps, threads call `ends` to
/// see whether the run is to end.
struct TuneProgress {
    std::function<void(std::string_view what, std::size_t steps)> begin;
    std::function<bool()> step;
    std::function<bool()> ends;
};

/// Number of settings with the least cost that are timed. The base, the base with the other split,
/// the setting with the fewest volume tests, and the best of every volume are timed besides.
inline constexpr std::size_t most_timed = 8;

/// Counts the work of settings in all frames: first settings that change one option, or the volume
/// and split; then all settings of the promising volumes. Then tries packed layouts of the best
/// settings, and times some settings and all layouts, which take turns at each frame, in few enough
/// frames to keep the run short. None if `progress` ended it.
std::optional<SceneTuning> tune_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const TuneOptions& options,
                                      const TuneProgress& progress);

}  // namespace scb::app
