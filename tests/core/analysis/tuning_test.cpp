#include "core/analysis/tuning.h"

#include <gtest/gtest.h>

#include <map>

namespace scb {
namespace {

std::map<Tuned, std::size_t> counts_of(const std::vector<TuneTrial>& trials) {
    std::map<Tuned, std::size_t> counts;
    for (const TuneTrial& trial : trials) ++counts[trial.tuned];
    return counts;
}

/// Costs of 10 but for those named by index.
std::vector<double> costs_of(const std::vector<TuneTrial>& trials,
                             const std::map<std::size_t, double>& others) {
    std::vector<double> costs(trials.size(), 10);
    for (const auto& [i, cost] : others) costs[i] = cost;
    return costs;
}

std::size_t find(const std::vector<TuneTrial>& trials, const TuneSetting& setting) {
    std::size_t i = 0;
    while (i < trials.size() && !(trials[i].setting == setting)) ++i;
    return i;
}

TEST(TuneTrials, ChangeOneThingAtATimeAndEachOnce) {
    TuneSetting corrected;
    corrected.overlap = {OverlapTest::corrected, 0.5};
    TuneSetting odd;
    odd.overlap = {OverlapTest::corrected, 0.123};
    odd.descent = DescentRule::alternating;
    odd.growth = BallGrowth::radius;
    for (const TuneSetting& base : {TuneSetting{}, corrected, odd}) {
        const std::vector<TuneTrial> trials = tune_trials(base);
        EXPECT_TRUE(trials[0].setting == base);
        auto counts = counts_of(trials);
        EXPECT_EQ(counts[Tuned::nothing], 1u);
        EXPECT_EQ(counts[Tuned::test], 4u);
        EXPECT_EQ(counts[Tuned::threshold], base == odd ? 18u : 17u);
        EXPECT_EQ(counts[Tuned::descent], 3u);
        EXPECT_EQ(counts[Tuned::growth], 1u);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const TuneSetting& setting = trials[i].setting;
            EXPECT_EQ(find(trials, setting), i);
            const bool other_overlap =
                !(TuneSetting{setting.overlap, base.descent, base.growth} == base);
            EXPECT_EQ(
                other_overlap + (setting.descent != base.descent) + (setting.growth != base.growth),
                i == 0 ? 0 : 1);
        }
        // All of 0.1, 0.15, ... 0.95 are there.
        for (int step = 2; step < 20; ++step) {
            TuneSetting setting = base;
            setting.overlap = {OverlapTest::corrected, 0.05 * step};
            setting.overlap.threshold = step / 20.0;
            EXPECT_LT(find(trials, setting), trials.size()) << step;
        }
    }
}

TEST(TuneTrials, ChangeOnlyWhatHasAnEffectOnTheVolume) {
    for (const auto& [kind, descents, growths] : {std::tuple{VolumeKind::scb2, 3u, 1u},
                                                  {VolumeKind::obb, 3u, 0u},
                                                  {VolumeKind::ball, 1u, 1u},
                                                  {VolumeKind::ritter, 1u, 0u}}) {
        auto counts = counts_of(tune_trials({}, kind));
        EXPECT_EQ(counts[Tuned::test] + counts[Tuned::threshold], 0u) << volume_kind_name(kind);
        EXPECT_EQ(counts[Tuned::descent], descents) << volume_kind_name(kind);
        EXPECT_EQ(counts[Tuned::growth], growths) << volume_kind_name(kind);
    }
}

TEST(TuneTrials, AThresholdCountsOnlyWhereTheTestHasOne) {
    TuneSetting x, y;
    y.overlap.threshold = 0.2;
    EXPECT_TRUE(x == y);
    x.overlap.test = y.overlap.test = OverlapTest::line8;
    EXPECT_FALSE(x == y);
}

TEST(BestTrial, IsTheBaseUnlessAnotherGainsEnough) {
    const std::vector<TuneTrial> trials = tune_trials({});
    EXPECT_EQ(best_trial(trials, costs_of(trials, {}), 0), 0u);
    EXPECT_EQ(best_trial(trials, costs_of(trials, {{7, 9.9}}), 0), 7u);
    EXPECT_EQ(best_trial(trials, costs_of(trials, {{7, 9.9}}), 0.02), 0u);
    EXPECT_EQ(best_trial(trials, costs_of(trials, {{7, 9.7}, {9, 9.6}, {10, 9.6}}), 0.02), 9u);
}

TEST(BestTrial, IsNeverTheTestThatMissesPairs) {
    const std::vector<TuneTrial> trials = tune_trials({});
    TuneSetting printed;
    printed.overlap.test = OverlapTest::printed;
    const std::size_t i = find(trials, printed);
    EXPECT_EQ(best_trial(trials, costs_of(trials, {{i, 1}}), 0), 0u);
    // Not even where it is the base.
    const std::vector<TuneTrial> of_printed = tune_trials(printed);
    EXPECT_EQ(best_trial(of_printed, costs_of(of_printed, {{0, 1}, {3, 9}}), 0.02), 3u);
}

TEST(BestTogether, TakesTheBestOfEachAlsoWhereTheBaseMissesPairs) {
    TuneSetting printed, descent = printed, extents;
    printed.overlap.test = descent.overlap.test = OverlapTest::printed;
    descent.descent = DescentRule::area;
    extents.overlap.test = OverlapTest::extents;
    const std::vector<TuneTrial> trials = tune_trials(printed);
    const auto best = best_together(
        trials, costs_of(trials, {{find(trials, descent), 8}, {find(trials, extents), 9}}), 0.02);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->setting.overlap.test, OverlapTest::extents);
    EXPECT_EQ(best->setting.descent, DescentRule::area);
}

TEST(BestTogether, TakesTheBestOfEach) {
    const std::vector<TuneTrial> trials = tune_trials({});
    EXPECT_FALSE(best_together(trials, costs_of(trials, {}), 0));
    TuneSetting overlap, descent, growth;
    overlap.overlap = {OverlapTest::corrected, 0.25};
    descent.descent = DescentRule::volume;
    growth.growth = BallGrowth::radius;
    const std::size_t o = find(trials, overlap), d = find(trials, descent),
                      g = find(trials, growth);
    // One change alone is a trial already.
    EXPECT_FALSE(best_together(trials, costs_of(trials, {{d, 9}}), 0));
    const auto best = best_together(trials, costs_of(trials, {{o, 9}, {d, 9.5}, {g, 9.9}}), 0.02);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->tuned, Tuned::several);
    EXPECT_TRUE(
        (best->setting ==
         TuneSetting{{OverlapTest::corrected, 0.25}, DescentRule::volume, BallGrowth::ritter}));
}

}  // namespace
}  // namespace scb
