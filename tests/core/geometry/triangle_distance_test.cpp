#include "scb/triangle_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/distance/precise_features.h"
#include "tests/core/geometry/distance_oracle.h"
#include "tests/core/geometry/distance_pairs.h"

namespace scb {
namespace {

TEST(TriangleDistanceResult, IsThatOfAnOracleInHigherPrecision) {
    Random random(17);
    int positive = 0;
    double worst = 0;
    for (int i = 0; i < 6'000 / effort; ++i) {
        const TrianglePair pair = random_shapes(random);
        const TriangleDistance found = triangle_distance(pair.a, pair.b);
        const double error = std::abs(static_cast<double>(
            distance_oracle::distance(pair.a, pair.b) - static_cast<long double>(found.distance)));
        ASSERT_LE(error, allowed_error(pair)) << i << " " << found.distance;
        worst = std::max(worst, error / allowed_error(pair));
        positive += found.distance > 0;
        ASSERT_NEAR((found.point_a - found.point_b).norm(), found.distance, allowed_error(pair))
            << i;
        EXPECT_LE(
            found.distance == 0
                ? 0
                : triangle_distance(pair.a, {found.point_a, found.point_a, found.point_a}).distance,
            allowed_error(pair))
            << i << ": the point is not on A";
    }
    EXPECT_GT(positive, 4'000 / effort);
    EXPECT_GT(worst, 0.05) << "the bound is far too large";
}

/// The distance of the points that double-doubles find.
double precise_distance(const TrianglePair& pair) {
    const PreciseFeatures closest = precise_features(pair.a, pair.b).front();
    const auto point = [](const TriangleCorners& t, const std::array<double, 3>& weights,
                          int axis) {
        long double sum = 0, all = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            sum += static_cast<long double>(weights[k]) * t[k][axis];
            all += weights[k];
        }
        return sum / all;
    };
    long double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const long double difference =
            point(pair.a, closest.weights_a, axis) - point(pair.b, closest.weights_b, axis);
        squared += difference * difference;
    }
    return static_cast<double>(std::sqrt(squared));
}

TEST(TriangleDistanceResult, IsExactForNearlyParallelEdges) {
    Random random(3);
    int tilted = 0;
    for (int i = 0; i < 20'000 / effort; ++i) {
        const TrianglePair pair = nearly_parallel(random);
        const TriangleDistance found = triangle_distance(pair.a, pair.b);
        if (found.distance == 0) continue;
        ASSERT_NEAR(found.distance, precise_distance(pair), allowed_error(pair)) << i;
        ++tilted;
    }
    EXPECT_GT(tilted, 8'000 / effort);
}

TEST(TriangleDistanceResult, IsZeroIfAndOnlyIfTheyIntersect) {
    Random random(5);
    int meeting = 0;
    for (int i = 0; i < 40'000 / effort; ++i) {
        const TrianglePair pair = as_doubles(random_grid_pair(random, 4));
        const TriangleDistance found = triangle_distance(pair.a, pair.b);
        const bool meet = triangles_overlap(pair.a, pair.b);
        ASSERT_EQ(found.distance == 0, meet) << i;
        if (meet) {
            EXPECT_EQ(found.point_a, found.point_b);
        }
        meeting += meet;
    }
    EXPECT_GT(meeting, 1000 / effort);
    // Squares of such gaps underflow.
    const TriangleCorners floor = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const TriangleCorners near = {Vec3(1, 1, 1e-200), Vec3(1, 1, 5), Vec3(2, 1, 5)};
    EXPECT_EQ(triangle_distance(floor, near).distance, 1e-200);
}

TEST(TriangleDistanceResult, HasTheSameBitsForAnyOrderOfCorners) {
    Random random(9);
    for (int i = 0; i < 5'000 / effort; ++i) {
        const TrianglePair pair = random_shapes(random);
        const TriangleDistance found = triangle_distance(pair.a, pair.b);
        for (const auto& [x, y, z] :
             {std::array<std::size_t, 3>{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
            const TriangleCorners a = {pair.a[x], pair.a[y], pair.a[z]},
                                  b = {pair.b[z], pair.b[x], pair.b[y]};
            const TriangleDistance other = triangle_distance(a, b);
            ASSERT_EQ(std::bit_cast<std::uint64_t>(found.distance),
                      std::bit_cast<std::uint64_t>(other.distance));
            EXPECT_TRUE(found.distance == 0 || found.point_a == other.point_a);
        }
        EXPECT_NEAR(triangle_distance(pair.b, pair.a).distance, found.distance,
                    2 * allowed_error(pair));
    }
}

// Triangles around an edge of A, and around a corner of B.
TEST(TriangleDistanceResult, HasTheSameBitsForTrianglesThatShareTheClosestFeatures) {
    Random random(11);
    const auto point = [&random] {
        return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, -1));
    };
    for (int i = 0; i < 2'000 / effort; ++i) {
        // A's ridge is on top, and B's tip is above it.
        const Vec3 first(-2, random.uniform(-0.2, 0.2), random.uniform(0, 0.1)),
            last(2, random.uniform(-0.2, 0.2), random.uniform(0, 0.1)),
            tip(random.uniform(-1, 1), random.uniform(-0.1, 0.1), random.uniform(1, 2));
        const auto of_b = [&] {
            return TriangleCorners{Vec3(tip + Vec3(0.1, 0.2, 1) - point()), tip,
                                   Vec3(tip - Vec3(0.2, 0.1, -1) - point())};
        };
        const auto of_a = [&] { return TriangleCorners{last, point(), first}; };
        const double found = triangle_distance(of_a(), of_b()).distance;
        for (int k = 0; k < 5; ++k) EXPECT_EQ(triangle_distance(of_a(), of_b()).distance, found);
    }
}

}  // namespace
}  // namespace scb
