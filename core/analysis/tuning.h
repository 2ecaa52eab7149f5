#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pass_counts.h"
#include "core/base/enum_names.h"
#include "scb/any_hierarchy.h"
#include "scb/collide.h"
#include "scb/overlap_options.h"

namespace scb {

/// One way to build the hierarchies of two bodies and to query them.
struct TuneSetting {
    VolumeKind volume = VolumeKind::scb;
    SplitMethod split = SplitMethod::section_3;
    OverlapOptions overlap;
    DescentRule descent = DescentRule::radius;
    BallGrowth growth = BallGrowth::ritter;
};

/// Whether both make the same queries. Options without effect are not compared, such as the
/// threshold of a test that has none.
bool operator==(const TuneSetting& x, const TuneSetting& y);

/// Whether both are queries of the same hierarchies.
bool same_hierarchies(const TuneSetting& x, const TuneSetting& y);

/// The option in which a setting differs from the base setting.
enum class Tuned {
    nothing,
    volume,
    split,
    test,
    threshold,  ///< the paper's a, of the test `corrected`
    descent,
    growth,
    several,
};

inline constexpr EnumNames<Tuned, 8> tuned_names = {"base",      "volume",  "split",  "test",
                                                    "threshold", "descent", "growth", "several"};

Tuned tuned(const TuneSetting& setting, const TuneSetting& base);

/// The base; then every volume with every split; then settings that differ from the base in one
/// other option: the overlap test, the descent rule, the growth rule, and if `thresholds` the
/// threshold of `corrected` from 0.1 to 0.95 in steps of 0.05. Each once.
std::vector<TuneSetting> first_trials(const TuneSetting& base, bool thresholds);

/// Every descent rule and growth rule with the volume and the split of `setting`; and, for slab cut
/// balls, each with the tests `symmetric`, `extents` and `corrected`. Each once.
std::vector<TuneSetting> refined_trials(const TuneSetting& setting);

/// The indices of first trials whose volume and split should be refined. With the base's test,
/// descent and growth, they take at most `refined_up_to` times the least cost,
/// Work::picoseconds, of such trials, or if `by_tests` the least N_v.
inline constexpr double refined_up_to = 1.3;
std::vector<std::size_t> settings_to_refine(std::span<const TuneSetting> trials,
                                            std::span<const Work> counts, bool by_tests);

/// The indices of the settings, least cost first; equal costs in the order of Work, equal
/// counts in order.
std::vector<std::size_t> best_first(std::span<const Work> counts);

/// A time that was measured several times.
struct TimeInterval {
    double low = 0, median = 0, high = 0;  ///< the least, the middle and the greatest
};
TimeInterval time_interval(std::vector<double> runs);

/// Whether no run of one took as long as a run of the other: the intervals do not meet.
bool apart(const TimeInterval& x, const TimeInterval& y);

/// Among the times that lie wholly below `base`, and above no other time wholly: the index of the
/// one with the least memory, the first of equals. Nothing if none is below.
std::optional<std::size_t> quickest_with_least_memory(std::span<const TimeInterval> times,
                                                      std::span<const double> bytes,
                                                      const TimeInterval& base);

}  // namespace scb
