#include "core/analysis/measure_correlation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb {
namespace {

MeasuredQuery query(double measure, double n_v, std::size_t volume) {
    return {{measure}, n_v, 0, 0, volume};
}

TEST(MeasureCorrelation, RanksWithinEachScene) {
    // Each scene by itself is in order; pooled, the cheap scene with large measures is not.
    const std::vector<MeasuredScene> scenes = {
        {query(101, 1, 0), query(102, 2, 1), query(103, 3, 2)},
        {query(1, 10, 0), query(2, 20, 1), query(3, 15, 2)}};
    const CostCorrelation c = cost_correlation(scenes, 0, &MeasuredQuery::n_v);
    EXPECT_EQ(c.of_scene[0], 1);
    EXPECT_EQ(c.of_scene[1], 0.5);
    EXPECT_EQ(c.mean, 0.75);
    EXPECT_EQ(c.least, 0.5);
    EXPECT_EQ(c.most, 1);
    EXPECT_LT(c.pooled, 0);
    EXPECT_EQ(c.queries, 6u);
    EXPECT_EQ(c.split_pairs, 0u);
}

TEST(MeasureCorrelation, ComparesSplitsOfOneVolume) {
    const std::vector<MeasuredScene> scenes = {
        // Of volume 0 the measure is right, of 1 wrong, of 2 it cannot tell; of 3 there is nothing
        // to tell.
        {query(1, 10, 0), query(2, 20, 0), query(2, 10, 1), query(1, 20, 1), query(5, 1, 2),
         query(5, 2, 2), query(1, 7, 3), query(2, 7, 3)}};
    const CostCorrelation c = cost_correlation(scenes, 0, &MeasuredQuery::n_v);
    EXPECT_EQ(c.split_pairs, 3u);
    EXPECT_EQ(c.split_agreement, 0.5);
}

TEST(MeasureCorrelation, LeavesOutScenesThatDoNotVary) {
    const std::vector<MeasuredScene> scenes = {{query(1, 5, 0), query(2, 5, 1)},
                                               {query(1, 5, 0), query(2, 6, 1)}};
    const CostCorrelation c = cost_correlation(scenes, 0, &MeasuredQuery::n_v);
    EXPECT_TRUE(std::isnan(c.of_scene[0]));
    EXPECT_EQ(c.mean, 1);
    EXPECT_TRUE(std::isnan(cost_correlation({}, 0, &MeasuredQuery::n_v).mean));
}

}  // namespace
}  // namespace scb
