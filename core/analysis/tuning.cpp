#include "core/analysis/tuning.h"

#include <algorithm>
#include <cassert>

namespace scb {
namespace {

// Adds the setting unless it is there.
void add_once(std::vector<TuneTrial>& trials, const TuneSetting& setting, Tuned tuned) {
    for (const TuneTrial& trial : trials)
        if (trial.setting == setting) return;
    trials.push_back({setting, tuned});
}

// The best of the trials in which nothing but one of these was changed.
const TuneSetting& best_of(std::span<const TuneTrial> trials, std::span<const double> costs,
                           double least_gain, std::initializer_list<Tuned> among) {
    const bool chooses_test = std::find(among.begin(), among.end(), Tuned::test) != among.end();
    std::vector<TuneTrial> chosen;
    std::vector<double> their_costs;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const bool is_among = std::find(among.begin(), among.end(), trials[i].tuned) != among.end();
        if (!is_among && trials[i].tuned != Tuned::nothing) continue;
        chosen.push_back(trials[i]);
        // Where the test is the same for all, it is no reason to prefer one.
        if (!chooses_test) chosen.back().setting.overlap.test = OverlapTest::symmetric;
        their_costs.push_back(costs[i]);
        places.push_back(i);
    }
    return trials[places[best_trial(chosen, their_costs, least_gain)]].setting;
}

}  // namespace

bool operator==(const TuneSetting& x, const TuneSetting& y) {
    return x.overlap.test == y.overlap.test &&
           (!has_threshold(x.overlap.test) || x.overlap.threshold == y.overlap.threshold) &&
           x.descent == y.descent && x.growth == y.growth;
}

std::vector<TuneTrial> tune_trials(const TuneSetting& base, VolumeKind kind) {
    std::vector<TuneTrial> trials = {{base, Tuned::nothing}};
    TuneSetting setting = base;
    if (kind == VolumeKind::scb) {
        for (const OverlapTest test : all_overlap_tests()) {
            setting.overlap.test = test;
            if (test != base.overlap.test) add_once(trials, setting, Tuned::test);
        }
        setting.overlap.test = OverlapTest::corrected;
        for (int step = 2; step < 20; ++step) {
            setting.overlap.threshold = step / 20.0;
            add_once(trials, setting, Tuned::threshold);
        }
    }
    setting = base;
    const auto by_size = [](DescentRule rule) { return rule != DescentRule::alternating; };
    const bool is_ball = kind == VolumeKind::ball || kind == VolumeKind::ritter;
    for (const DescentRule rule : all_descent_rules()) {
        // The larger of two balls is so by any measure.
        if (is_ball && by_size(rule) && by_size(base.descent)) continue;
        setting.descent = rule;
        add_once(trials, setting, Tuned::descent);
    }
    if (!has_growth(kind)) return trials;
    setting = base;
    for (const BallGrowth growth : {BallGrowth::ritter, BallGrowth::radius}) {
        setting.growth = growth;
        add_once(trials, setting, Tuned::growth);
    }
    return trials;
}

std::size_t best_trial(std::span<const TuneTrial> trials, std::span<const double> costs,
                       double least_gain) {
    assert(!trials.empty() && costs.size() == trials.size() && "every trial has a cost");
    std::size_t best = 0;
    bool found = is_sound(trials[0].setting.overlap.test);
    for (std::size_t i = 1; i < trials.size(); ++i) {
        if (!is_sound(trials[i].setting.overlap.test)) continue;
        const bool gains = costs[i] < costs[0] * (1 - least_gain);
        if (found && (costs[i] >= costs[best] || (best == 0 && !gains))) continue;
        best = i;
        found = true;
    }
    return best;
}

std::optional<TuneTrial> best_together(std::span<const TuneTrial> trials,
                                       std::span<const double> costs, double least_gain) {
    TuneSetting setting;
    setting.overlap = best_of(trials, costs, least_gain, {Tuned::test, Tuned::threshold}).overlap;
    setting.descent = best_of(trials, costs, least_gain, {Tuned::descent}).descent;
    setting.growth = best_of(trials, costs, least_gain, {Tuned::growth}).growth;
    for (const TuneTrial& trial : trials)
        if (trial.setting == setting) return std::nullopt;
    return TuneTrial{setting, Tuned::several};
}

}  // namespace scb
