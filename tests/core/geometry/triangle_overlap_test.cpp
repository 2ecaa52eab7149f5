#include "scb/triangle_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/coplanar_overlap.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_pair.h"
#include "tests/core/fit/point_sets.h"
#include "tests/core/geometry/triangle_pairs.h"

namespace scb {
namespace {

std::string shown(const TrianglePair& pair) {
    std::ostringstream out;
    out.precision(17);
    for (const TriangleCorners& t : {pair.a, pair.b})
        for (const Vec3& p : t) out << "(" << p.transpose() << ") ";
    return out.str();
}

// The answer in all 72 orders of corners and triangles; -1 where they differ.
int overlap_in_every_order(TrianglePair pair) {
    const int answer = triangles_overlap(pair.a, pair.b) ? 1 : 0;
    std::array<std::size_t, 3> i{0, 1, 2};
    do {
        std::array<std::size_t, 3> j{0, 1, 2};
        do {
            const TriangleCorners a{pair.a[i[0]], pair.a[i[1]], pair.a[i[2]]},
                b{pair.b[j[0]], pair.b[j[1]], pair.b[j[2]]};
            if (triangles_overlap(a, b) != (answer == 1)) return -1;
            if (triangles_overlap(b, a) != (answer == 1)) return -1;
        } while (std::next_permutation(j.begin(), j.end()));
    } while (std::next_permutation(i.begin(), i.end()));
    return answer;
}

template <class Map>
TrianglePair mapped(const TrianglePair& pair, Map map) {
    TrianglePair result;
    for (std::size_t i = 0; i < 3; ++i) {
        result.a[i] = map(pair.a[i]);
        result.b[i] = map(pair.b[i]);
    }
    return result;
}

// Every pair with corners among the given ones.
void expect_reference_for_all(const std::vector<IntegerPoint<std::int64_t>>& points) {
    const std::size_t n = points.size();
    std::size_t wrong = 0, overlapping = 0;
    const std::size_t step = effort;
    for (std::size_t code = 0; code < n * n * n * n * n * n; code += step) {
        GridTriangle a, b;
        std::size_t rest = code;
        for (GridTriangle* t : {&a, &b})
            for (auto& p : *t) {
                p = points[rest % n];
                rest /= n;
            }
        const bool overlap = triangles_overlap(as_doubles(a), as_doubles(b));
        if (overlap) ++overlapping;
        if (overlap != reference_overlap(a, b) && ++wrong == 1)
            ADD_FAILURE() << shown({as_doubles(a), as_doubles(b)}) << " overlap: " << overlap;
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(overlapping, 0u);
}

TEST(TriangleReference, KnowsSimplePairs) {
    const GridTriangle flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    EXPECT_TRUE(reference_overlap(flat, {{{1, 1, -1}, {1, 1, 1}, {6, 6, 0}}}));
    EXPECT_FALSE(reference_overlap(flat, {{{3, 3, -1}, {3, 3, 1}, {6, 6, 0}}}));
    EXPECT_TRUE(reference_overlap(flat, {{{2, 2, 0}, {5, 5, 1}, {5, 5, 2}}}));
    EXPECT_FALSE(reference_overlap(flat, {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}));
    EXPECT_TRUE(reference_overlap(flat, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}));
    EXPECT_TRUE(
        reference_overlap(as_doubles(flat), as_doubles({{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}})));
}

TEST(TrianglesOverlap, IsRightForEveryPairInTheUnitCube) {
    std::vector<IntegerPoint<std::int64_t>> points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1, i >> 1 & 1, i >> 2});
    expect_reference_for_all(points);
}

TEST(TrianglesOverlap, IsRightForEveryPairInAPlaneGrid) {
    std::vector<IntegerPoint<std::int64_t>> points;
    for (int i = 0; i < 9; ++i) points.push_back({i % 3, i / 3, i % 3 + 2 * (i / 3)});
    expect_reference_for_all(points);
}

TEST(TrianglesOverlap, IsRightForEveryPairOnALine) {
    std::vector<IntegerPoint<std::int64_t>> points;
    for (int i = 0; i < 5; ++i) points.push_back({5 - i, 1, i});
    expect_reference_for_all(points);
}

TEST(TrianglesOverlap, IsRightForAMillionPairsInSmallGrids) {
    Random random(1);
    std::array<int, 2> answers{};
    std::array<int, 4> degenerate{};
    for (int i = 0; i < 1200000 / effort; ++i) {
        const GridPair grid = random_grid_pair(random, 2 + random.below(5));
        const TrianglePair pair = as_doubles(grid);
        const bool expected = reference_overlap(grid.a, grid.b);
        ++answers[expected];
        ++degenerate[static_cast<std::size_t>(is_degenerate(pair.a) + 2 * is_degenerate(pair.b))];
        ASSERT_EQ(triangles_overlap(pair.a, pair.b), expected) << shown(pair);
    }
    for (const int count : answers) EXPECT_GT(count, 100000 / effort);
    for (const int count : degenerate) EXPECT_GT(count, 20000 / effort);
}

bool in_one_plane(const TrianglePair& pair) {
    const std::array<Vec3, 6> points = {pair.a[0], pair.a[1], pair.a[2],
                                        pair.b[0], pair.b[1], pair.b[2]};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = i + 1; j < 6; ++j)
            for (std::size_t k = j + 1; k < 6; ++k)
                for (std::size_t l = k + 1; l < 6; ++l)
                    if (orient3d(points[i], points[j], points[k], points[l]) != 0) return false;
    return true;
}

// Triangles cross if their interiors have a common point, and they are not in one plane.
TEST(TriangleContact, IsCrossingWhereInteriorsMeetInDifferentPlanes) {
    Random random(9);
    std::array<int, 3> counts{};
    for (int i = 0; i < 600000 / effort; ++i) {
        const GridPair grid = random_grid_pair(random, 2 + random.below(5));
        const TrianglePair pair = as_doubles(grid);
        const TriangleContact expected =
            !reference_overlap(grid.a, grid.b) ? TriangleContact::apart
            : reference_overlap(grid.a, grid.b, true) && !in_one_plane(pair)
                ? TriangleContact::crossing
                : TriangleContact::touching;
        ++counts[static_cast<std::size_t>(expected)];
        ASSERT_EQ(triangle_contact(pair.a, pair.b), expected) << shown(pair);
        ASSERT_EQ(triangle_contact(pair.b, pair.a), expected) << shown(pair);
    }
    for (const int count : counts) EXPECT_GT(count, 20000 / effort);
}

TEST(TrianglesOverlap, DependsOnNoOrder) {
    Random random(2);
    for (int i = 0; i < 20000 / effort; ++i) {
        const GridPair grid = random_grid_pair(random, 2 + random.below(4));
        const TrianglePair pair = as_doubles(grid);
        ASSERT_EQ(overlap_in_every_order(pair), reference_overlap(grid.a, grid.b)) << shown(pair);
    }
}

TEST(TrianglesOverlap, DoesNotChangeUnderExactScalingAndTranslation) {
    Random random(3);
    const auto exponent = [&](int range) {
        return static_cast<int>(random.below(static_cast<std::uint32_t>(2 * range + 1))) - range;
    };
    for (int i = 0; i < 200000 / effort; ++i) {
        const GridPair grid = random_grid_pair(random, 2 + random.below(4));
        const TrianglePair pair = as_doubles(grid);
        const bool expected = reference_overlap(grid.a, grid.b);
        // Scaled alike, each axis by itself, and up to the ends of the range of doubles.
        const int range = std::array<int, 3>{200, 500, 950}[random.below(3)];
        const int same = exponent(200);
        const std::array<int, 3> scale =
            random.below(2) == 0
                ? std::array<int, 3>{same, same, same}
                : std::array<int, 3>{exponent(range), exponent(range), exponent(range)};
        const auto scaled = [&](const Vec3& p) {
            return Vec3(std::ldexp(p[0], scale[0]), std::ldexp(p[1], scale[1]),
                        std::ldexp(p[2], scale[2]));
        };
        const TrianglePair moved = mapped(pair, scaled);
        ASSERT_EQ(triangles_overlap(moved.a, moved.b), expected) << shown(moved);
        const Vec3 far{std::ldexp(1, static_cast<int>(random.below(50))),
                       -std::ldexp(1, static_cast<int>(random.below(50))),
                       std::ldexp(3, static_cast<int>(random.below(48)))};
        const TrianglePair shifted =
            mapped(mapped(pair, [&](const Vec3& p) { return Vec3(p + far); }), scaled);
        ASSERT_EQ(triangles_overlap(shifted.a, shifted.b), expected) << shown(shifted);
    }
}

TEST(TrianglesOverlap, IsRightForNearlyCoplanarPairs) {
    Random random(4);
    int overlapping = 0;
    const int count = 12000 / effort;
    for (int i = 0; i < count; ++i) {
        TrianglePair pair = nearly_coplanar_pair(random);
        if (random.below(3) == 0)  // away from the origin, as a pose takes it
            pair = mapped(pair, [](const Vec3& p) { return Vec3(p + Vec3(1000, -3e4, 7)); });
        const bool expected = reference_overlap(pair.a, pair.b);
        overlapping += expected;
        ASSERT_EQ(overlap_in_every_order(pair), expected) << shown(pair);
    }
    EXPECT_GT(overlapping, count / 10);
    EXPECT_LT(overlapping, count * 9 / 10);
}

TEST(TrianglesOverlap, IsRightForTinyBesideLargeCoordinates) {
    Random random(5);
    constexpr std::array<double, 8> magnitudes{0, 0x1p-1074, 5e-320, 1e-300, 1e-60, 1, 1e70, 1e300};
    std::array<int, 2> answers{};
    for (int i = 0; i < 800 / effort; ++i) {
        TrianglePair pair;
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& p : *t)
                for (int axis = 0; axis < 3; ++axis) {
                    p[axis] = magnitudes[random.below(8)] * (1 + random.below(3));
                    if (random.below(2) == 0) p[axis] = -p[axis];
                }
        // One pair in two touches: the middle of an edge, rounded, or the corner itself.
        const std::uint32_t touch = random.below(4);
        if (touch == 0) pair.b[0] = pair.a[1];
        if (touch == 1) pair.b[0] = pair.a[0] / 2 + pair.a[1] / 2;
        const bool expected = reference_overlap(pair.a, pair.b);
        ++answers[expected];
        ASSERT_EQ(triangles_overlap(pair.a, pair.b), expected) << shown(pair);
        ASSERT_EQ(triangles_overlap(pair.b, pair.a), expected) << shown(pair);
    }
    for (const int count : answers) EXPECT_GT(count, 50 / effort);
}

TEST(TrianglesOverlap, SeesTheSmallestGap) {
    const TriangleCorners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    for (const double gap : {0x1p-1074, 1e-300, 1e-60}) {
        const TriangleCorners above{Vec3(0.1, 0.1, gap), Vec3(0.2, 0.1, 1), Vec3(0.1, 0.2, 1)};
        const TriangleCorners touching{Vec3(0.1, 0.1, 0), Vec3(0.2, 0.1, 1), Vec3(0.1, 0.2, 1)};
        const TriangleCorners through{Vec3(0.1, 0.1, -gap), Vec3(0.2, 0.1, 1), Vec3(0.1, 0.2, 1)};
        EXPECT_EQ(overlap_in_every_order({flat, above}), 0) << gap;
        EXPECT_EQ(overlap_in_every_order({flat, touching}), 1) << gap;
        EXPECT_EQ(overlap_in_every_order({flat, through}), 1) << gap;
    }
}

TEST(TrianglesOverlap, HoldsForIdenticalTriangles) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const double size = std::ldexp(1, static_cast<int>(random.below(400)) - 200);
        const TriangleCorners t{size * random_point(random), size * random_point(random),
                                size * random_point(random)};
        EXPECT_EQ(overlap_in_every_order({t, t}), 1);
        EXPECT_EQ(overlap_in_every_order({t, {t[0], t[0], t[0]}}), 1);
        EXPECT_EQ(overlap_in_every_order({t, {t[0], t[1], t[1]}}), 1);
    }
}

TEST(TrianglesOverlap, HoldsForNeighborsInAMesh) {
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = random_point(random), q = random_point(random);
        const TriangleCorners a{p, q, random_point(random)};
        EXPECT_EQ(overlap_in_every_order({a, {p, q, random_point(random)}}), 1);
        EXPECT_EQ(overlap_in_every_order({a, {p, random_point(random), random_point(random)}}), 1);
    }
}

TEST(TrianglesOverlap, FailsForTrianglesFarApart) {
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 far = 10 * random_unit_vector(random);
        TrianglePair pair;
        for (Vec3& p : pair.a) p = random_point(random);
        for (Vec3& p : pair.b) p = random_point(random) + far;
        EXPECT_EQ(overlap_in_every_order(pair), 0);
    }
}

TEST(TrianglesOverlap, ComparesDegenerateTrianglesAsSegmentsAndPoints) {
    const auto segment = [](const Vec3& p, const Vec3& q) {
        return TriangleCorners{p, q, (p + q) / 2};
    };
    const TriangleCorners x = segment({-1, 0, 0}, {1, 0, 0});
    EXPECT_EQ(overlap_in_every_order({x, segment({0, -1, 0}, {0, 1, 0})}), 1);
    EXPECT_EQ(overlap_in_every_order({x, segment({1, -1, 0}, {1, 1, 0})}), 1);
    EXPECT_EQ(overlap_in_every_order({x, segment({0, -1, 1}, {0, 1, 1})}), 0);   // skew
    EXPECT_EQ(overlap_in_every_order({x, segment({2, -1, 0}, {2, 1, 0})}), 0);   // beyond the end
    EXPECT_EQ(overlap_in_every_order({x, segment({-1, 1, 0}, {1, 1, 0})}), 0);   // parallel
    EXPECT_EQ(overlap_in_every_order({x, segment({1, 0, 0}, {2, 0, 0})}), 1);    // end to end
    EXPECT_EQ(overlap_in_every_order({x, segment({1.5, 0, 0}, {2, 0, 0})}), 0);  // on one line
    EXPECT_EQ(overlap_in_every_order({x, segment({0.5, 0, 0}, {0.5, 0, 0})}), 1);
    EXPECT_EQ(overlap_in_every_order({x, segment({0.5, 0, 1}, {0.5, 0, 1})}), 0);
    EXPECT_TRUE(coplanar_overlap(x, segment({1, 0, 0}, {2, 0, 0})));
    EXPECT_FALSE(coplanar_overlap(x, segment({1.5, 0, 0}, {2, 0, 0})));
    const TriangleCorners point = segment({3, 2, 1}, {3, 2, 1});
    EXPECT_EQ(overlap_in_every_order({point, point}), 1);
    EXPECT_EQ(overlap_in_every_order({point, segment({3, 2, 1}, {9, 2, 1})}), 1);
    EXPECT_EQ(overlap_in_every_order({point, segment({4, 2, 1}, {4, 2, 1})}), 0);
}

}  // namespace
}  // namespace scb
