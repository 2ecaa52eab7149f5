#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/enum_names.h"
#include "scb/any_hierarchy.h"
#include "scb/descent_rule.h"
#include "scb/overlap_options.h"

namespace scb {

/// One way to make queries.
struct TuneSetting {
    OverlapOptions overlap;
    DescentRule descent = DescentRule::radius;
    BallGrowth growth = BallGrowth::ritter;
};

/// Whether the two make the same queries: a threshold counts only where the test has one.
bool operator==(const TuneSetting& x, const TuneSetting& y);

/// What was changed of the setting that all others are compared with.
enum class Tuned {
    nothing,
    test,
    threshold,  ///< the paper's a, of the test `corrected`
    descent,
    growth,
    several,  ///< the best of each together
};

inline constexpr EnumNames<Tuned, 6> tuned_names = {"base",    "test",   "threshold",
                                                    "descent", "growth", "best"};

struct TuneTrial {
    TuneSetting setting;
    Tuned tuned = Tuned::nothing;
};

/// The base, then all settings that differ from it in one thing: the other overlap tests, the
/// threshold of `corrected` from 0.1 to 0.95 in steps of 0.05, the other descent rules, the other
/// growth rule. Each once, and of these what has an effect on such volumes.
std::vector<TuneTrial> tune_trials(const TuneSetting& base, VolumeKind kind = VolumeKind::scb);

/// The trial with the least cost of those with a sound test; of equal ones the first; the first of
/// all where none is sound. `costs` are
/// of the trials, in their order. The first trial stays unless another saves more than
/// `least_gain` of its cost, as a share.
std::size_t best_trial(std::span<const TuneTrial> trials, std::span<const double> costs,
                       double least_gain);

/// The best overlap test (with its threshold), the best descent rule and the best growth rule of
/// the trials together, each chosen as best_trial does; where that is none of the trials.
std::optional<TuneTrial> best_together(std::span<const TuneTrial> trials,
                                       std::span<const double> costs, double least_gain);

}  // namespace scb
