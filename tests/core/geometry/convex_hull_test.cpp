#include "core/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

using Points = std::vector<Vec3>;

Points cube() {
    Points points;
    for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
    return points;
}

void shuffle(Points& points, Random& random) {
    for (std::size_t i = points.size(); i > 1; --i)
        std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
}

TEST(ConvexHull, IsKnownOfSimpleSolids) {
    EXPECT_EQ(convex_hull(cube()).volume, 1);
    EXPECT_EQ(convex_hull(cube()).vertices.size(), 8u);
    EXPECT_DOUBLE_EQ(convex_hull(Points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}).volume, 1);
    Points filled = cube();
    for (int i = 0; i < 125; ++i) filled.emplace_back(i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0);
    EXPECT_EQ(convex_hull(filled).volume, 1);
}

TEST(ConvexHull, HasNoVolumeInAPlane) {
    EXPECT_EQ(convex_hull(Points{}).volume, 0);
    EXPECT_EQ(convex_hull(Points{{1, 2, 3}}).vertices.size(), 1u);
    EXPECT_EQ(convex_hull(Points(7, Vec3(1, 2, 3))).volume, 0);
    EXPECT_EQ(convex_hull(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}).volume, 0);
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        // Of a plane whose equation has small whole numbers, so that its points are exact.
        Points points;
        for (int j = 0; j < 20; ++j) {
            const double x = random.below(9), y = random.below(9);
            points.emplace_back(x, y, 3 * x - 2 * y);
        }
        const ConvexHull flat = convex_hull(points);
        EXPECT_EQ(flat.volume, 0);
        EXPECT_EQ(flat.vertices.size(), points.size());
    }
}

// Most of these points lie on lines and planes with others: facets are coplanar, and what is seen
// edge-on is for exact predicates to say.
TEST(ConvexHull, IsTheSameInAnyOrderOfPointsOfAGrid) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        Points points;
        const std::uint32_t count = 4 + random.below(60), size = 2 + random.below(4);
        for (std::uint32_t j = 0; j < count; ++j)
            points.emplace_back(random.below(size), random.below(size), random.below(size));
        const double volume = convex_hull(points).volume;
        EXPECT_EQ(6 * volume, std::round(6 * volume)) << "corners are whole numbers";
        for (int order = 0; order < 4; ++order) {
            shuffle(points, random);
            const ConvexHull hull = convex_hull(points);
            EXPECT_EQ(hull.volume, volume);
            Points corners;
            for (const std::uint32_t v : hull.vertices) corners.push_back(points[v]);
            EXPECT_EQ(convex_hull(corners).volume, volume);
        }
    }
}

// Points that are in a plane up to rounding: only exact predicates agree on the vertices.
TEST(ConvexHull, HasTheSameVerticesInAnyOrderOfPointsNearAPlane) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        Points points = random_points(random, 40, 0);
        std::vector<std::vector<double>> corners;
        for (int order = 0; order < 3; ++order) {
            shuffle(points, random);
            std::vector<double> of_order;
            for (const std::uint32_t v : convex_hull(points).vertices)
                of_order.push_back(points[v][0]);
            std::sort(of_order.begin(), of_order.end());
            corners.push_back(of_order);
        }
        EXPECT_LT(corners[0].size(), points.size());
        EXPECT_EQ(corners[0], corners[1]);
        EXPECT_EQ(corners[0], corners[2]);
    }
}

TEST(ConvexHull, OfPointsOfASphereApproachesItsVolume) {
    Random random(3);
    Points points;
    for (int i = 0; i < 20000; ++i) points.push_back(random_unit_vector(random));
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.vertices.size(), points.size());
    EXPECT_LT(hull.volume, 4 * std::numbers::pi / 3);
    EXPECT_GT(hull.volume, 4 * std::numbers::pi / 3 * 0.999);
}

}  // namespace
}  // namespace scb
