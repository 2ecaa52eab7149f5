#pragma once

#include "app/study/distance_setting.h"
#include "app/study/tune_run.h"

namespace scb::app {

/// A setting that was timed.
struct TimedSetting {
    DistanceSetting setting;
    std::uint64_t n_v = 0, n_p = 0;  ///< over the timed frames
    double bytes_per_triangle = 0;   ///< of the hierarchies of both bodies, topology included
    double build_ms = 0;             ///< of the hierarchies and of packing, processor time
    TimeInterval ms;                 ///< of a query, the mean over the timed frames
};

/// The quickest settings for the distances in a scene.
struct DistanceTuning {
    std::string scene;
    std::vector<std::string> bodies;     ///< names of A and B
    std::vector<std::size_t> triangles;  ///< of A and B
    std::vector<int> frames;             ///< that were timed
    BuildOptions build;                  ///< without split and growth, which settings have
    DistanceQuery asked;
    std::size_t tried = 0;           ///< settings
    std::vector<TimedSetting> rows;  ///< the base first, then the quickest first by the median
    int runs = 0;                    ///< of each timed query
    std::string no_layouts;          ///< a sentence: why no layout was tried

    const TimedSetting& base() const { return rows[0]; }
    /// The quickest row whose runs were all quicker than all runs of the base; the base if there is
    /// none.
    std::size_t best() const;
    /// The same of the rows without a layout.
    std::size_t best_unpacked() const;
};

struct DistanceTuneOptions {
    TuneSetting base;  ///< with the descent of all unpacked settings, and the growth of all
    BuildOptions build;
    DistanceQuery asked;  ///< with the order of the base
    int repeats = 5;
};

/// Tries every volume with every split, order and packed layout in a few frames by the clock. A
/// setting is given up once it takes far longer than the quickest so far. Then times the quickest,
/// which take turns, in few enough frames to keep the run short. Without orders if the pairs within
/// a tolerance are asked for. None if `progress` ended it.
std::optional<DistanceTuning> tune_distance(const scenes::Scene& scene, std::size_t a,
                                            std::size_t b, const std::vector<int>& frames,
                                            const DistanceTuneOptions& options,
                                            const TuneProgress& progress);

}  // namespace scb::app
