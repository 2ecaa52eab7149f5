#include "scenes/meshes/polygon.h"

#include <numeric>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

std::vector<Triangle> cut(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0u);
    std::vector<Triangle> triangles;
    append_polygon(corners, points, "polygon", triangles);
    return triangles;
}

/// Twice the area of the triangles in the plane z = 0; every one must be counterclockwise.
double area2(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const Triangle& t : triangles) {
        const Vec3 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
        EXPECT_GE(u[0] * v[1] - u[1] * v[0], 0);
        sum += u[0] * v[1] - u[1] * v[0];
    }
    return sum;
}

TEST(Polygon, ThatIsConvexBecomesAFanFromItsFirstCorner) {
    const auto triangles = cut({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}});
    EXPECT_EQ(triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Polygon, ThatIsConcaveIsCoveredWithoutOverlap) {
    const std::vector<Vec3> arrow = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    EXPECT_EQ(area2(arrow, cut(arrow)), 2);
    const std::vector<Vec3> comb = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0},
                                    {4, 1, 0}, {3, 1, 0}, {3, 3, 0}, {2, 3, 0},
                                    {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    const auto triangles = cut(comb);
    EXPECT_EQ(triangles.size(), comb.size() - 2);
    EXPECT_EQ(area2(comb, triangles), 2 * (5 + 3 * 2));
}

TEST(Polygon, SeenFromAnySideKeepsItsOrientation) {
    const std::vector<Vec3> flat = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    for (const int axis : {0, 1, 2}) {
        std::vector<Vec3> turned, backwards;
        for (const Vec3& p : flat)
            turned.emplace_back(p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]);
        backwards.assign(turned.rbegin(), turned.rend());
        for (const auto& points : {turned, backwards}) {
            const auto triangles = cut(points);
            ASSERT_EQ(triangles.size(), 2u);
            Vec3 normals[2];
            for (std::size_t i = 0; i < 2; ++i) {
                const Vec3 u = points[triangles[i][1]] - points[triangles[i][0]],
                           v = points[triangles[i][2]] - points[triangles[i][0]];
                normals[i] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                              u[0] * v[1] - u[1] * v[0]};
            }
            EXPECT_GT(dot(normals[0], normals[1]), 0);
        }
    }
}

TEST(Polygon, ThatCrossesItselfOrHasNoAreaBecomesAFan) {
    EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}),
              (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size(), 3u);
}

TEST(Polygon, ThatIsLargeAndConcaveIsRefused) {
    std::vector<Vec3> saw = {{0, -1, 0}};
    for (int i = 0; i < 3000; ++i) saw.emplace_back(3000 - i, i % 2, 0);
    expect_in("polygon is a concave polygon of 3001 corners", refusal([&] { cut(saw); }));
}

}  // namespace
}  // namespace scb::scenes
