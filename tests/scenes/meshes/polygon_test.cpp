#include "scenes/meshes/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

std::vector<Triangle> cut(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0u);
    std::vector<Triangle> triangles;
    PolygonCutter().append(corners, points, "polygon", triangles);
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
        std::vector<Vec3> turned;
        for (const Vec3& p : flat)
            turned.emplace_back(p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]);
        // Not from the concave corner on, from which a fan would do.
        const std::vector<Vec3> backwards = {turned[0], turned[3], turned[2], turned[1]};
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

TEST(Polygon, MayHaveAHoleThatIsBridged) {
    // A plate of 10 x 10 with a hole of 4 x 4, the bridge from corner 0 to the hole and back; from
    // every corner on.
    const std::vector<Vec3> plate = {{0, 0, 0}, {3, 3, 0}, {3, 7, 0},  {7, 7, 0},   {7, 3, 0},
                                     {3, 3, 0}, {0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    for (std::size_t start = 0; start < plate.size(); ++start) {
        std::vector<Vec3> turned(plate);
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start),
                    turned.end());
        const auto triangles = cut(turned);
        EXPECT_EQ(triangles.size(), plate.size() - 2);
        EXPECT_EQ(area2(turned, triangles), 2 * (100 - 16)) << start;
    }
}

TEST(Polygon, MayHaveManyCornersOnALineThatRoundingBends) {
    // The outline of a comb of unit cells, a corner at each unit, turned.
    std::vector<Vec3> comb;
    const auto add = [&](double x, double y) {
        constexpr double c = 0.955336489125606, s = 0.295520206661340;
        comb.emplace_back(c * x - s * y, s * x + c * y, 0);
    };
    constexpr int teeth = 6, height = 4;
    for (int x = 0; x <= 2 * teeth - 1; ++x) add(x, 0);
    for (int tooth = teeth - 1; tooth >= 0; --tooth) {
        for (int y = 1; y <= height; ++y) add(2 * tooth + 1, y);
        for (int y = height; y >= 1; --y) add(2 * tooth, y);
    }
    const auto triangles = cut(comb);
    EXPECT_EQ(triangles.size(), comb.size() - 2);
    double sum = 0, absolute = 0;
    for (const Triangle& t : triangles) {
        const Vec3 u = comb[t[1]] - comb[t[0]], v = comb[t[2]] - comb[t[0]];
        sum += u[0] * v[1] - u[1] * v[0];
        absolute += std::abs(u[0] * v[1] - u[1] * v[0]);
    }
    EXPECT_NEAR(sum, 2 * (2 * teeth - 1 + teeth * (height - 1)), 1e-9);
    EXPECT_NEAR(absolute, sum, 1e-9);
}

// Two spirals, one turn of 16 corners after the other: an ear is only at their ends.
TEST(Polygon, OfSomeSecondsIsRefused) {
    std::vector<Vec3> spiral;
    const auto add = [&](double turn, double out) {
        const double angle = 2 * 3.14159265358979323846 * turn;
        spiral.emplace_back((turn + out) * std::cos(angle), (turn + out) * std::sin(angle), 0);
    };
    constexpr int corners = 1000;
    for (int i = 0; i < corners; ++i) add(1 + i / 16.0, 0);
    for (int i = corners; i-- > 0;) add(1 + i / 16.0, -0.4);
    std::vector<std::uint32_t> all(spiral.size());
    std::iota(all.begin(), all.end(), 0u);
    PolygonCutter cutter;
    std::vector<Triangle> triangles;
    const std::string sentence = refusal([&] {
        for (int i = 0; i < 1000; ++i) {
            cutter.append(all, spiral, "polygon", triangles);
            triangles.clear();
        }
    });
    expect_in(
        "polygon is a concave polygon of 2000 corners, and up to it concave polygons take too "
        "long to cut; triangulate the file first.",
        sentence);
}

}  // namespace
}  // namespace scb::scenes
