#include "core/fit/extremal_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

/// A DOP whose extremes are points of these ids, drawn at random.
Dop26 dop_of_some(Random& random, const std::vector<std::int64_t>& ids) {
    Dop26 dop;
    const auto some = [&] {
        return static_cast<double>(ids[random.below(static_cast<std::uint32_t>(ids.size()))]);
    };
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        dop.upper_id[i] = some();
        dop.lower_id[i] = some();
    }
    return dop;
}

TEST(ExtremalPoints, AreEachThereOnceInTheOrderOfTheDirections) {
    Random random(41);
    const std::vector<Vec3> all = random_points(random, 4096);
    const PointArrays arrays(all);
    for (int round = 0; round < 400; ++round) {
        // Few and many distinct ones; every other time ids that are the same modulo 64.
        std::vector<std::int64_t> ids;
        for (int i = 0; i <= round % 27; ++i)
            ids.push_back(round % 2 == 0 ? static_cast<std::int64_t>(random.below(4096))
                                         : 64 * static_cast<std::int64_t>(random.below(64)) + 7);
        const Dop26 dop = dop_of_some(random, ids);
        FewPoints points;
        ExtremalPairs pairs;
        extremal_points(dop, arrays.view(), points, pairs);
        std::vector<double> met;
        const auto expect_next = [&](double id, std::int32_t index) {
            const auto at = std::find(met.begin(), met.end(), id);
            EXPECT_EQ(index, at - met.begin());
            if (at == met.end()) met.push_back(id);
            EXPECT_EQ(points[static_cast<std::size_t>(index)], all[static_cast<std::size_t>(id)]);
        };
        for (std::size_t i = 0; i < Dop26::directions; ++i) {
            expect_next(dop.upper_id[i], pairs.upper[i]);
            expect_next(dop.lower_id[i], pairs.lower[i]);
        }
        ASSERT_EQ(points.count, met.size());
        for (std::size_t i = points.count; i % 8 != 0; ++i) EXPECT_EQ(points[i], points[0]);
    }
}

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
