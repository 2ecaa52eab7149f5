#include "core/analysis/tuning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace scb {
namespace {

std::map<Tuned, std::size_t> counts_of(const std::vector<TuneSetting>& trials) {
    std::map<Tuned, std::size_t> counts;
    for (const TuneSetting& setting : trials) ++counts[tuned(setting, trials[0])];
    return counts;
}

bool each_once(const std::vector<TuneSetting>& trials) {
    for (std::size_t i = 0; i < trials.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (trials[i] == trials[j]) return false;
    return true;
}

TuneSetting with(VolumeKind volume, SplitMethod split = SplitMethod::section_3) {
    TuneSetting setting;
    setting.volume = volume;
    setting.split = split;
    return setting;
}

TEST(TuneSetting, IsTheSameWhereWhatDiffersHasNoEffect) {
    TuneSetting x, y;
    y.overlap.threshold = 0.2;
    EXPECT_TRUE(x == y);
    x.overlap.test = y.overlap.test = OverlapTest::line8;
    EXPECT_FALSE(x == y);
    x = y = with(VolumeKind::obb);
    y.overlap.test = OverlapTest::extents;
    y.growth = BallGrowth::radius;
    EXPECT_TRUE(x == y);
    y.descent = DescentRule::area;
    EXPECT_FALSE(x == y);
    // The larger of two balls is so by any measure.
    x.volume = y.volume = VolumeKind::ball;
    x.growth = y.growth;
    EXPECT_TRUE(x == y);
    y.descent = DescentRule::alternating;
    EXPECT_FALSE(x == y);
}

TEST(FirstTrials, TakeEveryVolumeWithEverySplitAndChangeOneOtherThing) {
    TuneSetting corrected;
    corrected.overlap = {OverlapTest::corrected, 0.5};
    TuneSetting odd;
    odd.overlap = {OverlapTest::corrected, 0.123};
    odd.descent = DescentRule::alternating;
    odd.growth = BallGrowth::radius;
    odd.split = SplitMethod::cost;
    for (const TuneSetting& base : {TuneSetting{}, corrected, odd}) {
        const std::vector<TuneSetting> trials = first_trials(base, true);
        EXPECT_TRUE(trials[0] == base);
        EXPECT_TRUE(each_once(trials));
        auto counts = counts_of(trials);
        const std::size_t volumes = all_volume_kinds().size();
        EXPECT_EQ(counts[Tuned::nothing], 1u);
        EXPECT_EQ(counts[Tuned::volume], volumes - 1);
        EXPECT_EQ(counts[Tuned::split], 1u);
        EXPECT_EQ(counts[Tuned::several], volumes - 1);
        EXPECT_EQ(counts[Tuned::test], 4u);
        EXPECT_EQ(counts[Tuned::threshold], base == odd ? 18u : 17u);
        EXPECT_EQ(counts[Tuned::descent], 3u);
        EXPECT_EQ(counts[Tuned::growth], 1u);
    }
}

TEST(FirstTrials, ChangeOnlyWhatHasAnEffectOnTheVolume) {
    for (const auto& [kind, descents, growths] : {std::tuple{VolumeKind::scb2, 3u, 1u},
                                                  {VolumeKind::obb, 3u, 0u},
                                                  {VolumeKind::ball, 1u, 1u},
                                                  {VolumeKind::ritter, 1u, 0u}}) {
        auto counts = counts_of(first_trials(with(kind), true));
        EXPECT_EQ(counts[Tuned::test] + counts[Tuned::threshold], 0u) << volume_kind_name(kind);
        EXPECT_EQ(counts[Tuned::descent], descents) << volume_kind_name(kind);
        EXPECT_EQ(counts[Tuned::growth], growths) << volume_kind_name(kind);
    }
}

TEST(RefinedTrials, AreAllThatCanBeChosenOfAVolumeAndASplit) {
    for (const auto& [kind, count] : {std::pair{VolumeKind::scb, 24u},
                                      {VolumeKind::scb2, 8u},
                                      {VolumeKind::obb, 4u},
                                      {VolumeKind::ball, 4u},
                                      {VolumeKind::ritter, 2u}}) {
        const std::vector<TuneSetting> trials = refined_trials(with(kind, SplitMethod::cost));
        EXPECT_EQ(trials.size(), count) << volume_kind_name(kind);
        EXPECT_TRUE(each_once(trials));
        for (const TuneSetting& setting : trials) {
            EXPECT_EQ(setting.volume, kind);
            EXPECT_EQ(setting.split, SplitMethod::cost);
            EXPECT_TRUE(is_sound(setting.overlap.test));
        }
    }
}

TEST(WorthRefining, AreVolumesAndSplitsNearTheBestByTestsOrByCost) {
    const std::vector<TuneSetting> trials = first_trials({}, true);
    std::vector<Work> counts(trials.size(), {1000, 100, 1000, 91'000});
    const auto place = [&](const TuneSetting& setting) {
        return static_cast<std::size_t>(std::find(trials.begin(), trials.end(), setting) -
                                        trials.begin());
    };
    const std::size_t boxes = place(with(VolumeKind::obb, SplitMethod::cost)),
                      two = place(with(VolumeKind::scb2)), balls = place(with(VolumeKind::ball));
    TuneSetting extents;
    extents.overlap.test = OverlapTest::extents;
    counts[boxes] = {100, 9, 900, 9'000};
    counts[two] = {129, 9, 9000, 17'100};
    counts[balls] = {900, 0, 9900, 9'900};
    // Few operations, but much time, since the triangle tests are many.
    counts[place(with(VolumeKind::ritter))] = {900, 100, 10, 90'010};
    counts[place(extents)] = {1, 1, 1, 1};  // not with the test of the base
    std::vector<std::size_t> expected = {boxes, two, balls};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(settings_to_refine(trials, counts, true), expected);
}

TEST(BestFirst, OrdersByCostThenVolumeTestsThenPlace) {
    const std::vector<Work> counts = {{1, 1, 0, 900}, {2, 0, 1, 900}, {9, 0, 2, 2},
                                      {9, 0, 1, 1},   {9, 0, 1, 1},   {0, 9, 0, 8100}};
    EXPECT_EQ(best_first(counts), (std::vector<std::size_t>{3, 4, 2, 0, 1, 5}));
}

TEST(TimeInterval, IsFromTheLeastToTheMost) {
    const TimeInterval x = time_interval({3, 1, 2, 10}), y = time_interval({11, 12}),
                       z = time_interval({10});
    EXPECT_EQ(x.low, 1);
    EXPECT_EQ(x.median, 2.5);
    EXPECT_EQ(x.high, 10);
    EXPECT_TRUE(apart(x, y));
    EXPECT_TRUE(apart(y, x));
    EXPECT_FALSE(apart(x, z));
    EXPECT_FALSE(apart(z, x));
}

TEST(QuickestWithLeastMemory, IsOneThatNoOtherIsMeasurablyQuickerThan) {
    const TimeInterval base{10, 11, 12};
    const auto chosen = [&](std::vector<TimeInterval> times, std::vector<double> bytes) {
        return quickest_with_least_memory(times, bytes, base);
    };
    EXPECT_EQ(chosen({}, {}), std::nullopt);
    EXPECT_EQ(chosen({{9, 9.5, 10}, {11, 11, 11}}, {1, 1}), std::nullopt) << "they meet the base";
    // Of two between which no difference was measured the smaller; of equals the first.
    EXPECT_EQ(chosen({{4, 5, 6}, {5, 6, 7}}, {80, 60}), 1u);
    EXPECT_EQ(chosen({{4, 5, 6}, {5, 6, 7}}, {60, 60}), 0u);
    // Small, but measurably slower than another one.
    EXPECT_EQ(chosen({{4, 5, 6}, {7, 8, 9}}, {80, 60}), 0u);
    // The last is not apart from the one with the least median, but from the second.
    EXPECT_EQ(chosen({{1, 2, 8}, {3, 3, 4}, {5, 6, 7}}, {80, 70, 60}), 1u);
}

}  // namespace
}  // namespace scb
