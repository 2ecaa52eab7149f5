#include "core/geometry/common_area.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb {
namespace {

const TriangleCorners base_triangle = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};

double area_of(const TriangleCorners& a, const TriangleCorners& b) {
    return std::sqrt(squared_norm(area_normal(common_area(a, b)))) / 2;
}

TEST(CommonArea, IsTheTriangleItselfOfTwoThatAreEqual) {
    EXPECT_EQ(common_area(base_triangle, base_triangle).size(), 3u);
    EXPECT_DOUBLE_EQ(area_of(base_triangle, base_triangle), 2);
}

TEST(CommonArea, IsTheSameForEachOrderOfCorners) {
    const TriangleCorners other = {Vec3(1, -1, 0), Vec3(1, 3, 0), Vec3(-1, 1, 0)},
                          turned = {other[0], other[2], other[1]};
    // The strip of base_triangle left of x = 1 and between the two slanted edges of `other`.
    EXPECT_DOUBLE_EQ(area_of(base_triangle, other), 1.5);
    EXPECT_DOUBLE_EQ(area_of(base_triangle, turned), 1.5);
    EXPECT_DOUBLE_EQ(area_of(other, base_triangle), 1.5);
}

TEST(CommonArea, HasUpToSixCorners) {
    const TriangleCorners up = {Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(3, 6, 0)},
                          down = {Vec3(0, 4, 0), Vec3(3, -2, 0), Vec3(6, 4, 0)};
    EXPECT_EQ(common_area(up, down).size(), 6u);
}

/// As where two faces are divided along different diagonals.
TEST(CommonArea, HasACornerOnTheOtherTrianglesEdgeOnce) {
    const TriangleCorners half = {Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(0, 2, 0)};
    const std::vector<Vec3> corners = common_area(base_triangle, half);
    ASSERT_EQ(corners.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(corners[i], corners[(i + 1) % 3]);
}

TEST(CommonArea, IsEmptyForTrianglesThatTouchAtAnEdgeOrACornerOrAreApart) {
    const TriangleCorners at_edge = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, -2, 0)},
                          at_corner = {Vec3(2, 0, 0), Vec3(4, 0, 0), Vec3(4, 2, 0)},
                          apart = {Vec3(5, 5, 0), Vec3(6, 5, 0), Vec3(5, 6, 0)};
    for (const TriangleCorners& other : {at_edge, at_corner, apart})
        EXPECT_TRUE(common_area(base_triangle, other).empty());
}

TEST(CommonArea, IsEmptyForTrianglesThatCrossOrLieAboveEachOther) {
    const TriangleCorners crossing = {Vec3(0, 0, -1), Vec3(2, 0, 1), Vec3(0, 2, 1)};
    EXPECT_TRUE(common_area(base_triangle, crossing).empty());
    for (const double height : {1e-5, -1e-5}) {
        TriangleCorners above = base_triangle;
        for (Vec3& corner : above) corner[2] = height;
        EXPECT_TRUE(common_area(base_triangle, above).empty());
        EXPECT_TRUE(common_area(above, base_triangle).empty());
    }
    // A rounded pose moves a plane by less.
    TriangleCorners rounded = base_triangle;
    for (Vec3& corner : rounded) corner[2] = 1e-8;
    EXPECT_EQ(common_area(base_triangle, rounded).size(), 3u);
}

TEST(CommonArea, OfASmallTriangleIsInThePlaneOfTheLargeOne) {
    const TriangleCorners small = {Vec3(0.5, 0.5, 0), Vec3(0.501, 0.5, 1e-9), Vec3(0.5, 0.501, 0)};
    EXPECT_NEAR(area_of(base_triangle, small), 5e-7, 1e-12);
    EXPECT_NEAR(area_of(small, base_triangle), 5e-7, 1e-12);
}

TEST(CommonArea, OfADegenerateTriangleIsEmpty) {
    const TriangleCorners line = {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(2, 2, 0)};
    EXPECT_TRUE(common_area(base_triangle, line).empty());
    EXPECT_TRUE(common_area(line, base_triangle).empty());
    EXPECT_TRUE(common_area(line, line).empty());
}

}  // namespace
}  // namespace scb
