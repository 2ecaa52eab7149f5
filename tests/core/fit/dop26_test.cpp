#include "core/fit/dop26.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(Dop26, DirectionsAreThirteenAndNoTwoParallel) {
    const auto& directions = dop26_directions;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        EXPECT_NEAR(directions[i].norm() * directions.inverse_length[i], 1, 1e-15);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(cross(directions[i], directions[j]).norm(), 0.5);
    }
}

TEST(Dop26, HoldsTheExtremesOfEveryDirection) {
    Random random(21);
    const std::vector<Vec3> points = random_points(random, 100);
    const Dop26 dop = dop26_of(PointArrays(points).view());
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        double upper = -1e9, lower = 1e9;
        for (const Vec3& p : points) {
            upper = std::max(upper, dot(dop26_directions[i], p));
            lower = std::min(lower, dot(dop26_directions[i], p));
        }
        EXPECT_NEAR(dop.upper[i], upper, 1e-15);
        EXPECT_NEAR(dop.lower[i], lower, 1e-15);
        EXPECT_NEAR(dot(dop26_directions[i], points[static_cast<std::size_t>(dop.upper_id[i])]),
                    upper, 1e-15);
        EXPECT_NEAR(dot(dop26_directions[i], points[static_cast<std::size_t>(dop.lower_id[i])]),
                    lower, 1e-15);
    }
}

TEST(Dop26, MergingPartsGivesTheWholeTiesIncluded) {
    Random random(22);
    for (int round = 0; round < 50; ++round) {
        // Coordinates in {-1, 0, 1}: ties in almost every direction.
        std::vector<Vec3> points;
        for (int i = 0; i < 20; ++i)
            points.push_back(Vec3{int(random.below(3)) - 1.0, int(random.below(3)) - 1.0,
                                  int(random.below(3)) - 1.0});
        const PointArrays arrays(points);
        const Dop26 whole = dop26_of(arrays.view());
        const Dop26 a = dop26_of(arrays.view().sub(0, 8)),
                    b = dop26_of(arrays.view().sub(8, 12), 8);
        for (const Dop26& merged : {merge(a, b), merge(b, a), merge(whole, a), merge(b, whole)}) {
            EXPECT_EQ(merged.upper, whole.upper);
            EXPECT_EQ(merged.lower, whole.lower);
            EXPECT_EQ(merged.upper_id, whole.upper_id);
            EXPECT_EQ(merged.lower_id, whole.lower_id);
        }
    }
}

}  // namespace
}  // namespace scb
