#include "core/fit/flat_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/fit/few_points.h"

namespace scb {
namespace {

double width(const std::vector<FlatPoint>& points, const FlatPoint& direction) {
    double least = INFINITY, most = -INFINITY;
    for (const FlatPoint& p : points) {
        const double along = p[0] * direction[0] + p[1] * direction[1];
        least = std::min(least, along);
        most = std::max(most, along);
    }
    return most - least;
}

double narrowest_width(std::vector<FlatPoint> points) {
    const FlatPoint direction = narrowest_direction(points);
    EXPECT_NEAR(std::hypot(direction[0], direction[1]), 1, 1e-15);
    return width(points, direction);
}

TEST(NarrowestDirection, OfAnyPointsIsNoWiderThanOthers) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        std::vector<FlatPoint> points(3 + random.below(FewPoints::capacity - 2));
        const double flat = std::pow(10, -6 * random.uniform());
        for (FlatPoint& p : points) p = {random.uniform(), flat * random.uniform()};
        const double least = narrowest_width(points);
        // The one that is least wide is between two of these, and a little of one to the side
        // widens by that share of the length at most.
        constexpr int ways = 720;
        for (int k = 0; k < ways; ++k) {
            const double angle = k * std::numbers::pi / ways;
            EXPECT_LE(least, width(points, {std::cos(angle), std::sin(angle)}) + 1e-15);
        }
    }
}

TEST(NarrowestDirection, IsThatOfTheFirstEdgeOfARectangle) {
    EXPECT_DOUBLE_EQ(narrowest_width({{0, 0}, {3, 4}, {3 - 0.8, 4 + 0.6}, {-0.8, 0.6}}), 1);
}

TEST(NarrowestDirection, OfPointsOnALineIsAcrossThem) {
    EXPECT_NEAR(narrowest_width({{0, 0}, {2, 1}, {6, 3}, {4, 2}}), 0, 1e-15);
    EXPECT_NEAR(narrowest_width({{5, 1}, {-5, 1}}), 0, 1e-15);
}

TEST(NarrowestDirection, OfPointsThatCoincideIsTheFirstAxis) {
    const FlatPoint first = {1, 0};
    std::vector<FlatPoint> none, one = {{3, 4}}, same(FewPoints::capacity, {3, 4});
    for (std::vector<FlatPoint>* points : {&none, &one, &same})
        EXPECT_EQ(narrowest_direction(*points), first) << points->size();
}

}  // namespace
}  // namespace scb
