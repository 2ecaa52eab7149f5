#include "core/analysis/tuning.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "core/base/statistics.h"

namespace scb {
namespace {

constexpr bool is_ball(VolumeKind kind) {
    return kind == VolumeKind::ball || kind == VolumeKind::ritter;
}

/// The larger of two balls is larger by any measure.
DescentRule effective_descent(const TuneSetting& s) {
    return is_ball(s.volume) && s.descent != DescentRule::alternating ? DescentRule::radius
                                                                      : s.descent;
}

bool same_overlap(const TuneSetting& x, const TuneSetting& y) {
    if (x.volume != VolumeKind::scb || y.volume != VolumeKind::scb) return true;
    return x.overlap.test == y.overlap.test &&
           (!has_threshold(x.overlap.test) || x.overlap.threshold == y.overlap.threshold);
}

bool same_growth(const TuneSetting& x, const TuneSetting& y) {
    return !has_growth(x.volume) || !has_growth(y.volume) || x.growth == y.growth;
}

void add_once(std::vector<TuneSetting>& trials, const TuneSetting& setting) {
    if (std::find(trials.begin(), trials.end(), setting) == trials.end()) trials.push_back(setting);
}

}  // namespace

bool same_hierarchies(const TuneSetting& x, const TuneSetting& y) {
    return x.volume == y.volume && x.split == y.split && same_growth(x, y);
}

bool operator==(const TuneSetting& x, const TuneSetting& y) {
    return same_hierarchies(x, y) && same_overlap(x, y) &&
           effective_descent(x) == effective_descent(y);
}

Tuned tuned(const TuneSetting& setting, const TuneSetting& base) {
    Tuned found = Tuned::nothing;
    const auto changed = [&](bool is, Tuned what) {
        if (is) found = found == Tuned::nothing ? what : Tuned::several;
    };
    changed(setting.volume != base.volume, Tuned::volume);
    changed(setting.split != base.split, Tuned::split);
    if (!same_overlap(setting, base))
        changed(true, has_threshold(setting.overlap.test) &&
                              setting.overlap.threshold != base.overlap.threshold
                          ? Tuned::threshold
                          : Tuned::test);
    changed(
        setting.descent != base.descent && effective_descent(setting) != effective_descent(base),
        Tuned::descent);
    changed(!same_growth(setting, base), Tuned::growth);
    return found;
}

std::vector<TuneSetting> first_trials(const TuneSetting& base, bool thresholds) {
    std::vector<TuneSetting> trials = {base};
    for (const SplitMethod split : {SplitMethod::section_3, SplitMethod::cost})
        for (const VolumeKind volume : all_volume_kinds()) {
            TuneSetting setting = base;
            setting.volume = volume;
            setting.split = split;
            add_once(trials, setting);
        }
    TuneSetting setting = base;
    if (base.volume == VolumeKind::scb) {
        for (const OverlapTest test : all_overlap_tests()) {
            setting.overlap.test = test;
            add_once(trials, setting);
        }
        setting.overlap.test = OverlapTest::corrected;
        for (int step = 2; thresholds && step < 20; ++step) {
            setting.overlap.threshold = step / 20.0;
            add_once(trials, setting);
        }
    }
    setting = base;
    for (const DescentRule rule : all_descent_rules()) {
        setting.descent = rule;
        add_once(trials, setting);
    }
    setting = base;
    for (const BallGrowth growth : {BallGrowth::ritter, BallGrowth::radius}) {
        setting.growth = growth;
        add_once(trials, setting);
    }
    return trials;
}

std::vector<TuneSetting> refined_trials(const TuneSetting& base) {
    std::vector<TuneSetting> trials;
    for (const BallGrowth growth : {BallGrowth::ritter, BallGrowth::radius})
        for (const OverlapTest test :
             {OverlapTest::symmetric, OverlapTest::extents, OverlapTest::corrected})
            for (const DescentRule rule : all_descent_rules()) {
                TuneSetting setting = base;
                setting.growth = growth;
                setting.overlap.test = test;
                setting.descent = rule;
                add_once(trials, setting);
            }
    return trials;
}

std::vector<std::size_t> settings_to_refine(std::span<const TuneSetting> trials,
                                            std::span<const Work> counts, bool by_tests) {
    assert(!trials.empty() && counts.size() == trials.size() && "every trial has counts");
    std::vector<std::size_t> grid;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        TuneSetting as_base = trials[0];
        as_base.volume = trials[i].volume;
        as_base.split = trials[i].split;
        if (trials[i] == as_base) grid.push_back(i);
    }
    const auto most = [&](const auto& count) {
        std::uint64_t fewest = count(counts[0]);
        for (const std::size_t i : grid) fewest = std::min(fewest, count(counts[i]));
        return refined_up_to * static_cast<double>(fewest);
    };
    const auto n_v = [](const Work& work) { return work.volume_tests; };
    const auto time = [](const Work& work) { return work.picoseconds; };
    const double most_n_v = most(n_v), most_cost = most(time);
    std::erase_if(grid, [&](std::size_t i) {
        return (!by_tests || static_cast<double>(n_v(counts[i])) > most_n_v) &&
               static_cast<double>(time(counts[i])) > most_cost;
    });
    return grid;
}

std::vector<std::size_t> best_first(std::span<const Work> counts) {
    std::vector<std::size_t> places(counts.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::stable_sort(places.begin(), places.end(), [&](std::size_t x, std::size_t y) {
        return std::pair(counts[x].picoseconds, counts[x]) <
               std::pair(counts[y].picoseconds, counts[y]);
    });
    return places;
}

TimeInterval time_interval(std::vector<double> runs) {
    assert(!runs.empty() && "a time that was measured");
    const auto [low, high] = std::minmax_element(runs.begin(), runs.end());
    const TimeInterval interval{*low, 0, *high};
    return {interval.low, median(std::move(runs)), interval.high};
}

bool apart(const TimeInterval& x, const TimeInterval& y) {
    return x.high < y.low || y.high < x.low;
}

std::optional<std::size_t> quickest_with_least_memory(std::span<const TimeInterval> times,
                                                      std::span<const double> bytes,
                                                      const TimeInterval& base) {
    assert(times.size() == bytes.size() && "as many of both");
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool is_quick = times[i].high < base.low &&
                              std::none_of(times.begin(), times.end(), [&](const TimeInterval& t) {
                                  return t.high < times[i].low;
                              });
        if (is_quick && (!found || bytes[i] < bytes[*found])) found = i;
    }
    return found;
}

}  // namespace scb
