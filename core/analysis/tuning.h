#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pass_counts.h"
#include "core/base/enum_names.h"
#include "scb/any_hierarchy.h"
#include "scb/descent_rule.h"
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

/// Whether the two make the same queries: what has no effect on their volumes does not count, such
/// as a threshold of a test that has none.
bool operator==(const TuneSetting& x, const TuneSetting& y);

/// Whether both are queries of the same hierarchies.
bool same_hierarchies(const TuneSetting& x, const TuneSetting& y);

/// What a setting changes of the base, with which all are compared.
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

/// The base first; then every volume with every split, and what differs from the base in one other
/// thing: the other overlap tests, the threshold of `corrected` from 0.1 to 0.95 in steps of 0.05,
/// the other descent rules, the other growth rule. Each once.
std::vector<TuneSetting> first_trials(const TuneSetting& base);

/// Every descent rule and growth rule with the volume and the split of `setting`; and, for slab cut
/// balls, each with the tests `symmetric`, `extents` and `corrected`. Each once.
std::vector<TuneSetting> refined_trials(const TuneSetting& setting);

/// Those of the first trials whose volume and split are worth being refined: with the test, descent
/// and growth of the base, they take at most so many times the least N_v, or the least estimated
/// cost, of all that have these. By their first places.
inline constexpr double worth_refining = 1.3;
std::vector<std::size_t> worth_refining_of(std::span<const TuneSetting> trials,
                                           std::span<const Work> counts);

/// The places of the settings, the one with the least estimated cost first; of equal costs by the
/// order of Work, of equal counts the first.
std::vector<std::size_t> best_first(std::span<const Work> counts);

/// A time that was measured several times.
struct TimeInterval {
    double low = 0, median = 0, high = 0;  ///< the least, the middle and the greatest
};
TimeInterval time_interval(std::vector<double> runs);

/// Whether no run of one took as long as a run of the other.
bool apart(const TimeInterval& x, const TimeInterval& y);

/// Of the times that lie wholly below `base` and that no other of them is wholly below, the place
/// of the one with the least memory, the first of equals. Nothing where none is below.
std::optional<std::size_t> quickest_with_least_memory(std::span<const TimeInterval> times,
                                                      std::span<const double> bytes,
                                                      const TimeInterval& base);

}  // namespace scb
