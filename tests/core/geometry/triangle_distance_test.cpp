#include "core/geometry/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace scb {
namespace {

TriangleCorners moved(const TriangleCorners& t, const Vec3& by) {
    return {Vec3(t[0] + by), Vec3(t[1] + by), Vec3(t[2] + by)};
}

TriangleCorners random_triangle(Random& random, double size) {
    TriangleCorners t;
    for (Vec3& corner : t)
        for (int k = 0; k < 3; ++k) corner[k] = random.uniform(0, size);
    return t;
}

TEST(TriangleDistance, IsThatOfKnownPairs) {
    const TriangleCorners floor = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    // A corner above the inside, one above an edge's outside, and an edge across an edge.
    EXPECT_DOUBLE_EQ(triangle_gap(floor, {Vec3(1, 1, 2), Vec3(1, 1, 5), Vec3(2, 1, 5)}), 2);
    EXPECT_DOUBLE_EQ(triangle_gap(floor, {Vec3(-3, 1, 4), Vec3(-9, 1, 4), Vec3(-9, 2, 8)}), 5);
    EXPECT_DOUBLE_EQ(triangle_gap(floor, {Vec3(1, -2, -3), Vec3(1, -2, 3), Vec3(1, -8, 0)}), 2);
    // A needle that is stuck through the floor, 0.25 from its edge and 0.5 below it.
    EXPECT_NEAR(triangle_depth(floor, {Vec3(1, 0.25, -0.5), Vec3(1, 0.25, 9), Vec3(1.01, 0.25, 9)}),
                0.25, 1e-12);
    EXPECT_NEAR(triangle_depth(floor, {Vec3(1, 1, -0.125), Vec3(1, 1, 9), Vec3(1.01, 1, 9)}), 0.125,
                1e-12);
    EXPECT_EQ(triangle_depth(floor, moved(floor, Vec3(1, 1, 0))), 0) << "in one plane";
}

// A triangle that moves by less than the gap does not meet the other. If it moves by a little more
// than the gap along the right direction, it does. The same for depths, the other way round.
TEST(TriangleDistance, IsTheLengthOfTheShortestWay) {
    Random random(3);
    int meeting = 0;
    for (int i = 0; i < 2000; ++i) {
        const TriangleCorners a = random_triangle(random, 1),
                              b = random_triangle(random, i % 3 == 0 ? 0.05 : 1);
        const bool meet = triangles_overlap(a, b);
        meeting += meet;
        const double length = meet ? triangle_depth(a, b) : triangle_gap(a, b);
        bool changed = false;
        for (int k = 0; k < 60; ++k) {
            Vec3 way;
            for (int axis = 0; axis < 3; ++axis) way[axis] = random.uniform(-1, 1);
            way /= std::sqrt(squared_norm(way));
            EXPECT_EQ(triangles_overlap(a, moved(b, way * (length * (1 - 1e-9)))), meet) << i;
            changed |= triangles_overlap(a, moved(b, way * (length * 1.5))) != meet;
        }
        // Some random way out is seldom much longer than the shortest.
        if (length > 0.01 && meet) {
            EXPECT_TRUE(changed) << i;
        }
    }
    EXPECT_GT(meeting, 200);
}

}  // namespace
}  // namespace scb
