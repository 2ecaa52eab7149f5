#include "core/geometry/triangle_segment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/triangle_pair.h"
#include "scb/triangle_distance.h"
#include "scb/triangle_overlap.h"
#include "tests/core/fit/point_sets.h"
#include "tests/core/geometry/triangle_pairs.h"

namespace scb {
namespace {

// In long double: the normal of a sliver says little in double.
using Long3 = Eigen::Matrix<long double, 3, 1>;

long double long_dot(const Long3& a, const Long3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Long3 long_cross(const Long3& a, const Long3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Long3 a = from.cast<long double>(), ab = to.cast<long double>() - a,
                ap = point.cast<long double>() - a;
    const long double squared = long_dot(ab, ab);
    const long double t = squared > 0 ? std::clamp(long_dot(ap, ab) / squared, 0.0L, 1.0L) : 0;
    const Long3 rest = ap - t * ab;
    return static_cast<double>(std::sqrt(long_dot(rest, rest)));
}

double distance(const Vec3& p, const TriangleCorners& t) {
    const double to_edges =
        std::min({distance_to_segment(p, t[0], t[1]), distance_to_segment(p, t[1], t[2]),
                  distance_to_segment(p, t[2], t[0])});
    std::array<Long3, 3> edges, to_p;
    for (std::size_t i = 0; i < 3; ++i) {
        edges[i] = t[(i + 1) % 3].cast<long double>() - t[i].cast<long double>();
        to_p[i] = p.cast<long double>() - t[i].cast<long double>();
    }
    const Long3 n = long_cross(edges[0], edges[1]);
    const long double squared = long_dot(n, n);
    if (squared == 0) return to_edges;
    for (std::size_t i = 0; i < 3; ++i)
        if (long_dot(long_cross(edges[i], to_p[i]), n) < 0) return to_edges;
    return std::min(to_edges,
                    static_cast<double>(std::abs(long_dot(n, to_p[0])) / std::sqrt(squared)));
}

bool in_box(const Vec3& p, const TriangleCorners& t) {
    const Vec3 lower = t[0].cwiseMin(t[1]).cwiseMin(t[2]),
               upper = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
}

double size_of(const TrianglePair& pair) {
    double size = 0;
    for (const TriangleCorners* t : {&pair.a, &pair.b})
        for (const Vec3& p : *t) size = std::max(size, p.cwiseAbs().maxCoeff());
    return size;
}

// A value where the triangles overlap, in both boxes and near both triangles.
void expect_segment_in_both(const TrianglePair& pair, double tolerance) {
    const auto segment = triangles_intersection(pair.a, pair.b);
    ASSERT_EQ(segment.has_value(), triangles_overlap(pair.a, pair.b));
    if (!segment) return;
    for (const Vec3& p : {segment->a, segment->b})
        for (const TriangleCorners* t : {&pair.a, &pair.b}) {
            ASSERT_TRUE(in_box(p, *t));  // fails for NaN, too
            ASSERT_LE(distance(p, *t), tolerance * size_of(pair));
        }
}

double length(const LineSegment& s) { return (s.b - s.a).norm(); }

void expect_ends(const TriangleCorners& a, const TriangleCorners& b, const Vec3& p, const Vec3& q) {
    const auto segment = triangles_intersection(a, b);
    ASSERT_TRUE(segment);
    const double same = (segment->a - p).norm() + (segment->b - q).norm(),
                 exchanged = (segment->a - q).norm() + (segment->b - p).norm();
    EXPECT_LT(std::min(same, exchanged), 1e-15)
        << segment->a.transpose() << " to " << segment->b.transpose();
}

const TriangleCorners flat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(TrianglesIntersection, IsThePieceOfTheLineOfBothPlanes) {
    // Through a, through b, and overlapping along the line y = 1.
    expect_ends(flat, {Vec3(-9, 1, -1), Vec3(9, 1, -1), Vec3(0, 1, 9)}, {0, 1, 0}, {3, 1, 0});
    expect_ends(flat, {Vec3(1, 1, -1), Vec3(2, 1, -1), Vec3(1.5, 1, 1)}, {1.25, 1, 0},
                {1.75, 1, 0});
    expect_ends(flat, {Vec3(2, 1, 1), Vec3(2, 1, -1), Vec3(9, 1, 0)}, {2, 1, 0}, {3, 1, 0});
    expect_ends(flat, {Vec3(-3, 1, 2), Vec3(2, 1, 0), Vec3(-3, 1, -2)}, {0, 1, 0}, {2, 1, 0});
}

TEST(TrianglesIntersection, IsAPointWhereTrianglesTouchInOne) {
    expect_ends(flat, {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(2, 1, 1)}, {1, 1, 0}, {1, 1, 0});
    expect_ends(flat, {Vec3(4, 0, 0), Vec3(5, 0, 1), Vec3(5, 1, 1)}, {4, 0, 0}, {4, 0, 0});
    expect_ends(flat, {Vec3(2, -1, -1), Vec3(2, 1, 1), Vec3(2, -1, 1)}, {2, 0, 0}, {2, 0, 0});
    EXPECT_FALSE(triangles_intersection(flat, {Vec3(1, 1, 1), Vec3(1, 2, 1), Vec3(2, 1, 1)}));
}

TEST(TrianglesIntersection, IsTheLongestEdgePieceOfCoplanarTriangles) {
    expect_ends(flat, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1.5, 0)}, {2, 1, 0}, {1, 1.5, 0});
    expect_ends(flat, {Vec3(-1, 1, 0), Vec3(9, 1, 0), Vec3(-1, 1.1, 0)}, {0, 1, 0}, {3, 1, 0});
    expect_ends(flat, {Vec3(1, 0, 0), Vec3(9, 0, 0), Vec3(5, -4, 0)}, {1, 0, 0}, {4, 0, 0});
    expect_ends(flat, flat, {4, 0, 0}, {0, 4, 0});
    expect_ends(flat, {Vec3(4, 0, 0), Vec3(5, 0, 0), Vec3(5, 1, 0)}, {4, 0, 0}, {4, 0, 0});
}

TEST(TrianglesIntersection, OfSegmentsAndPointsIsWhatTheyShare) {
    const auto segment = [](const Vec3& p, const Vec3& q) { return TriangleCorners{p, q, q}; };
    expect_ends(flat, segment({1, 1, 2}, {1, 1, -2}), {1, 1, 0}, {1, 1, 0});
    expect_ends(flat, segment({-1, 1, 0}, {1, 1, 0}), {0, 1, 0}, {1, 1, 0});
    expect_ends(flat, segment({1, 1, 0}, {1, 1, 0}), {1, 1, 0}, {1, 1, 0});
    expect_ends(segment({0, 0, 0}, {2, 2, 2}), segment({2, 0, 0}, {0, 2, 2}), {1, 1, 1}, {1, 1, 1});
    expect_ends(segment({0, 0, 0}, {2, 2, 2}), segment({3, 3, 3}, {1, 1, 1}), {1, 1, 1}, {2, 2, 2});
    expect_ends(segment({1, 2, 3}, {1, 2, 3}), segment({1, 2, 3}, {1, 2, 3}), {1, 2, 3}, {1, 2, 3});
}

TEST(TrianglesIntersection, IsInBothTrianglesOfRandomPairs) {
    Random random(21);
    for (int i = 0; i < 100000 / effort; ++i) {
        TrianglePair pair;
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& p : *t) p = random_point(random);
        expect_segment_in_both(pair, 1e-15);
        if (HasFatalFailure()) return;
    }
}

TEST(TrianglesIntersection, IsInBothTrianglesOfPairsInSmallGrids) {
    Random random(22);
    for (int i = 0; i < 200000 / effort; ++i) {
        expect_segment_in_both(as_doubles(random_grid_pair(random, 2 + random.below(5))), 1e-15);
        if (HasFatalFailure()) return;
    }
}

TEST(TrianglesIntersection, IsInBothTrianglesOfNearlyCoplanarPairs) {
    Random random(23);
    for (int i = 0; i < 50000 / effort; ++i) {
        expect_segment_in_both(nearly_coplanar_pair(random), 1e-15);
        if (HasFatalFailure()) return;
    }
}

TEST(TrianglesIntersection, StaysInBothBoxesWhateverTheMagnitudes) {
    Random random(24);
    int overlapping = 0;
    for (int i = 0; i < 20000 / effort; ++i) {
        TrianglePair pair;
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& p : *t)
                for (int axis = 0; axis < 3; ++axis)
                    p[axis] = std::array<double, 8>{0,  0x1p-1074, 1e-300, 1,
                                                    -1, 1e70,      1e308,  -1e308}[random.below(8)];
        const auto segment = triangles_intersection(pair.a, pair.b);
        ASSERT_EQ(segment.has_value(), triangles_overlap(pair.a, pair.b));
        if (!segment) continue;
        ++overlapping;
        for (const Vec3& p : {segment->a, segment->b})
            ASSERT_TRUE(in_box(p, pair.a) && in_box(p, pair.b));
    }
    EXPECT_GT(overlapping, 1000 / effort);
}

// No point of an edge of one that is in the other lies beyond the ends; nor is any such piece of an
// edge longer where the triangles are coplanar.
TEST(TrianglesIntersection, IsTheWholeIntersectionOrItsLongestEdge) {
    Random random(25);
    int crossing = 0, coplanar = 0;
    for (int i = 0; i < 40000 / effort; ++i) {
        const TrianglePair pair = as_doubles(random_grid_pair(random, 3 + random.below(4)));
        const auto segment = triangles_intersection(pair.a, pair.b);
        if (!segment) continue;
        PairSides sides{};
        const bool one_plane = arrange(pair.a, pair.b, sides) == Arrangement::one_plane;
        ++(one_plane ? coplanar : crossing);
        for (const auto& [t, other] : {std::pair{&pair.a, &pair.b}, std::pair{&pair.b, &pair.a}})
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const Vec3 p = (*t)[edge], q = (*t)[(edge + 1) % 3];
                int first = -1, last = -1;
                for (int step = 0; step <= 60; ++step) {
                    const Vec3 at = p + step / 60.0 * (q - p);
                    if (distance(at, *other) > 1e-12) continue;
                    last = step;
                    if (first < 0) first = step;
                    if (one_plane) continue;
                    ASSERT_LT(distance_to_segment(at, segment->a, segment->b), 1e-10);
                }
                if (first < 0) continue;
                ASSERT_GE(length(*segment), (last - first) / 60.0 * (q - p).norm() - 1e-10);
            }
    }
    EXPECT_GT(crossing, 1000 / effort);
    EXPECT_GT(coplanar, 1000 / effort);
}

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
    EXPECT_DOUBLE_EQ(
        triangle_distance(floor, {Vec3(1, 1, 2), Vec3(1, 1, 5), Vec3(2, 1, 5)}).distance, 2);
    EXPECT_DOUBLE_EQ(
        triangle_distance(floor, {Vec3(-3, 1, 4), Vec3(-9, 1, 4), Vec3(-9, 2, 8)}).distance, 5);
    EXPECT_DOUBLE_EQ(
        triangle_distance(floor, {Vec3(1, -2, -3), Vec3(1, -2, 3), Vec3(1, -8, 0)}).distance, 2);
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
        const double length = meet ? triangle_depth(a, b) : triangle_distance(a, b).distance;
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
