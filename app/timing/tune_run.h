#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/query/scene_query.h"
#include "core/analysis/tuning.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// What one setting took, over all frames.
struct TuneRow {
    TuneSetting setting;
    Work counts;
    std::uint64_t pairs = 0;
    bool misses_pairs = false;       ///< has fewer in some frame than another setting has
    double bytes_per_triangle = 0;   ///< of the hierarchies of both bodies, topology included
    double build_ms = 0;             ///< processor time of building these
    std::optional<TimeInterval> ms;  ///< of a query, the mean over the timed frames; of some rows
};

/// What the hierarchies of a setting take in a packed layout, over all frames. Layouts have a test
/// and a descent of their own, and wide nodes and large leaves have other counts.
struct TuneLayout {
    std::size_t row = 0;  ///< whose hierarchies are packed
    PackedLayout layout;
    std::uint64_t n_v = 0, n_p = 0, pairs = 0;
    bool misses_pairs = false;  ///< finds others than the row does: there is an error then
    double bytes_per_triangle = 0;
    double build_ms = 0;  ///< that of the row and packing
    std::optional<TimeInterval> ms;
};

/// The settings of one scene, the base first.
struct SceneTuning {
    std::string scene;
    std::vector<std::string> bodies;     ///< names of A and B
    std::vector<std::size_t> triangles;  ///< of A and B
    std::vector<int> frames, timed_frames;
    BuildOptions build;  ///< but for split and growth, which are tuned
    std::vector<TuneRow> rows;
    std::vector<std::size_t> best;  ///< rows that find all pairs, by estimated_cost, the least
                                    ///< first; of rows with equal counts only the first
    std::size_t fewest_tests = 0, fewest_operations = 0;  ///< of these
    int runs = 0;                                         ///< of each timed query
    std::size_t least_time = 0;       ///< see least_time_of; 0 where nothing is timed
    std::vector<TuneLayout> layouts;  ///< of the row with the fewest tests of each packable volume
    std::string no_layouts;           ///< why some are not there: a sentence
    /// The layout with the least time, if that is measurably less than that of `recommended`; of
    /// those that no other is measurably quicker than, the one with the least memory.
    std::optional<std::size_t> quicker_layout;

    double mean(std::uint64_t sum) const {
        return static_cast<double>(sum) / static_cast<double>(frames.size());
    }
    const TuneRow& base() const { return rows[0]; }
    /// So many of the best, the best first, without those that differ from a better one in the
    /// growth of balls alone; and the recommended one. The base is not among them.
    std::vector<std::size_t> listed(std::size_t most) const;
    /// How many other rows have the counts of this one.
    std::size_t equals(std::size_t row) const;
    bool timed() const { return rows[0].ms.has_value(); }
    /// The setting to use: that with the least time, or where nothing is timed with the least
    /// estimated cost, since a test of some volumes takes a hundred times what it takes of others.
    /// A row that misses pairs is never it.
    std::size_t recommended() const { return timed() ? least_time : best[0]; }
};

struct TuneOptions {
    TuneSetting base;  ///< overlap and growth as by default where they mean nothing to the volume
    BuildOptions build;
    bool every = false;   ///< all settings together, not just those of the volumes worth it
    int repeats = 0;      ///< of each timed query; 0: nothing is timed
    bool layouts = true;  ///< whether packed layouts are tried
};

/// Places of the frames, evenly spread, in which tune_scene takes some seconds to count: all, or
/// fewer. `all` is what the queries of all `frames` frames take with one setting.
std::vector<std::size_t> counted_frames(std::size_t frames, const Work& all);

/// Told of a part of the run that begins, with how many steps it has; then of each step, by
/// `step`, which ends the run by returning false. Within a step, which may be long, threads ask
/// whether the run is to end.
struct TuneProgress {
    std::function<void(std::string_view what, std::size_t steps)> begin;
    std::function<bool()> step;
    std::function<bool()> ends;
};

/// So many settings with the least cost are timed, beside the base, the base with the other split,
/// the one with the fewest volume tests, and the best of every volume.
inline constexpr std::size_t most_timed = 8;

/// Counts what the settings take in the frames, all of them: those that change one thing or take
/// another volume and split, then of the volumes that are worth it all that can be chosen. Then
/// tries packed layouts of the best, and times some, which take turns at each frame, so many frames
/// as keep the run short. Nothing where it was ended.
std::optional<SceneTuning> tune_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const TuneOptions& options,
                                      const TuneProgress& progress);

}  // namespace scb::app
