#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb {
namespace {

using Values = std::vector<double>;

TEST(RankCorrelation, GivesEqualValuesTheMeanOfTheirRanks) {
    EXPECT_EQ(ranks(Values{}), Values{});
    EXPECT_EQ(ranks(Values{30, 10, 20}), (Values{3, 1, 2}));
    EXPECT_EQ(ranks(Values{5, 7, 5, 7, 7, 1}), (Values{2.5, 5, 2.5, 5, 5, 1}));
}

TEST(RankCorrelation, IsSpearmansWorkedByHand) {
    EXPECT_EQ(rank_correlation(Values{1, 2, 3}, Values{10, 200, 3000}), 1);
    EXPECT_EQ(rank_correlation(Values{1, 2, 3}, Values{-1, -20, -300}), -1);
    // Ranks 1 2 3 4 5 and 2 1 4 3 5: 1 - 6 (1 + 1 + 1 + 1) / (5 * 24) = 0.8.
    EXPECT_DOUBLE_EQ(rank_correlation(Values{1, 2, 3, 4, 5}, Values{20, 10, 40, 30, 50}), 0.8);
    // Ranks 1 2.5 2.5 4 and 1 3 2 4, less 2.5: products 2.25 + 0 + 0 + 2.25, squares 4.5 and 5.
    EXPECT_DOUBLE_EQ(rank_correlation(Values{1, 2, 2, 3}, Values{1, 3, 2, 4}),
                     4.5 / std::sqrt(4.5 * 5));
}

TEST(RankCorrelation, IsNoNumberWhereNothingVaries) {
    EXPECT_TRUE(std::isnan(rank_correlation(Values{1, 1, 1}, Values{1, 2, 3})));
    EXPECT_TRUE(std::isnan(rank_correlation(Values{1}, Values{2})));
    EXPECT_TRUE(std::isnan(rank_correlation(Values{}, Values{})));
}

}  // namespace
}  // namespace scb
