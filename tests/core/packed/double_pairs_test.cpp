#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/packed/packed_query.h"
#include "scb/triangle_overlap.h"
#include "tests/core/geometry/triangle_pairs.h"
#include "tests/core/packed/touching_triangles.h"

namespace scb {
namespace {

/// Expects that each level decides pairs {t, t} as the exact test does, and leaves at most so many
/// undecided.
void expect_exact(const Mesh& a, const Mesh& b, const Pose& b_to_a,
                  const std::vector<IndexPair>& expected, std::size_t most_undecided) {
    for (const SimdLevel level : available_simd_levels()) {
        PackedFindings found;
        for (std::uint32_t t = 0; t < a.triangles.size(); ++t) found.undecided.push_back({t, t});
        decide_in_doubles(a, b, b_to_a, level, found);
        EXPECT_LE(found.undecided.size(), most_undecided) << simd_level_name(level);
        for (const IndexPair& pair : found.undecided)
            if (triangles_overlap(corners(a, pair.a),
                                  transform_corners(b_to_a, corners(b, pair.b))))
                found.pairs.push_back(pair);
        std::sort(found.pairs.begin(), found.pairs.end());
        EXPECT_EQ(found.pairs, expected) << simd_level_name(level);
    }
}

/// Adds the triangles of a pair {t, t}.
void add_pair(Mesh& a, const std::array<Vec3, 3>& p, Mesh& b, const std::array<Vec3, 3>& q) {
    const auto add = [](Mesh& mesh, const std::array<Vec3, 3>& corners) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    add(a, p);
    add(b, q);
}

/// Pairs of triangles that touch, or nearly so; and which of them intersect. `place` moves a corner
/// of the pair that is to come.
template <class Next>
std::vector<IndexPair> add_touching(Random& random, std::uint32_t count, Mesh& a, Mesh& b,
                                    Next next_place) {
    std::vector<IndexPair> expected;
    for (std::uint32_t t = 0; t < count; ++t) {
        const TrueCorners truth = touching(random);
        const auto place = next_place();
        std::array<Vec3, 3> p, q;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = place(corner_p(truth, i));
            q[i] = place(corner_q(truth, i));
        }
        add_pair(a, p, b, q);
        if (triangles_overlap(corners(a, t), corners(b, t))) expected.push_back({t, t});
    }
    return expected;
}

// Triangles that touch, or nearly so. What is decided on is gone from the undecided.
TEST(DoublePairs, AreDecidedOnlyWhereTheExactTestDecidesSo) {
    Random random(5);
    Mesh a, b;
    const auto next_place = [&random] {
        const Vec3 at =
            std::ldexp(1.0, static_cast<int>(random.below(40)) - 20) * grid_point(random);
        // Not by whole numbers any more: all sums round.
        const double size = 0.1 + random.uniform();
        return [at, size](const Vec3& corner) { return Vec3(size * corner + at); };
    };
    const auto expected =
        add_touching(random, static_cast<std::uint32_t>(200'000 / effort), a, b, next_place);
    expect_exact(a, b, Pose{}, expected, a.triangles.size() / 2);
}

// Products of three differences underflow to 0 for the smallest of these triangles. An exact 0
// would mean that they touch.
TEST(DoublePairs, OfTinyTrianglesAreLeftToTheExactTest) {
    Random random(15);
    Mesh a, b;
    const auto next_place = [&random] {
        const double size = std::ldexp(1.0, -190 - static_cast<int>(random.below(200)));
        return [size](const Vec3& corner) { return Vec3(size * corner); };
    };
    const auto expected =
        add_touching(random, static_cast<std::uint32_t>(20'000 / effort), a, b, next_place);
    expect_exact(a, b, Pose{}, expected, a.triangles.size());
}

/// A triangle of a CAD part: in a plane along two axes, or in one along one axis, with coordinates
/// of a grid that are no whole numbers.
std::array<Vec3, 3> part_of_a_box(Random& random) {
    const auto x = [&random] { return 0.1 * static_cast<double>(random.below(6)); };
    std::array<Vec3, 3> t;
    for (Vec3& v : t) v = {x(), x(), x()};
    const int axis = static_cast<int>(random.below(3));
    if (random.below(3) != 0) {
        t[1][axis] = t[2][axis] = t[0][axis];
    } else {
        const double along = t[1][axis];
        t[1] = t[0];
        t[1][axis] = along;
    }
    const std::uint32_t turn = random.below(3);
    std::rotate(t.begin(), t.begin() + turn, t.end());
    return t;
}

// Parts that are moved along an axis: planes are the same, edges are on one line, corners are
// beside each other. Nine tenths are decided without the exact test; degenerate triangles are not.
TEST(DoublePairs, OfPartsThatLieOnEachOtherAreMostlyCertain) {
    Random random(8);
    for (int axis = 0; axis < 3; ++axis) {
        Mesh a, b;
        Pose pose;
        pose.translation[axis] = 0.1 * random.uniform();
        const auto count = static_cast<std::uint32_t>(60'000 / effort);
        for (std::uint32_t t = 0; t < count; ++t)
            for (Mesh* mesh : {&a, &b}) {
                for (const Vec3& v : part_of_a_box(random)) mesh->vertices.push_back(v);
                mesh->triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
            }
        std::vector<IndexPair> pairs;
        for (std::uint32_t t = 0; t < count; ++t)
            if (triangles_overlap(corners(a, t), transform_corners(pose, corners(b, t))))
                pairs.push_back({t, t});
        EXPECT_GT(pairs.size(), count / 10);
        expect_exact(a, b, pose, pairs, count / 10);
    }
}

// An edge of b lies in a's plane, beside a, on a line that passes through a. The third corner is
// above a, so that projections do not separate the triangles.
TEST(DoublePairs, WithAnEdgeInThePlaneOfTheOtherAreCertain) {
    Random random(4);
    Mesh a, b;
    const auto count = static_cast<std::uint32_t>(1000 / effort);
    for (std::uint32_t t = 0; t < count; ++t) {
        const double y = 0.1 + 0.8 * random.uniform(), x = 1.1 + random.uniform();
        add_pair(a, {Vec3(0, 0, 0.3), Vec3(1, 0, 0.3), Vec3(random.uniform(), 1, 0.3)}, b,
                 {Vec3(x, y, 0.3), Vec3(x + 1, y, 0.3), Vec3(0.5, 0.5, 1.3)});
    }
    expect_exact(a, b, Pose{}, {}, 0);
}

// Products of coordinates near the least doubles are 0, and their determinants are not.
TEST(DoublePairs, AreNotCertainWhereProductsUnderflow) {
    Mesh a, b;
    // The corner of b is above a's plane, x + y + z = d with d = 2^-700, by products of 2^-1400.
    constexpr double d = 0x1p-700;
    a.vertices = {{d, 0, 0}, {0, d, 0}, {0, 0, d}};
    b.vertices = {{d, d, d}, {2 * d, d, d}, {d, 2 * d, d}};
    for (Mesh* mesh : {&a, &b}) mesh->triangles = {{0, 1, 2}};
    expect_exact(a, b, Pose{}, {}, 1);
    b.vertices[0] = {-d, -d, -d};
    expect_exact(a, b, Pose{}, {{0, 0}}, 1);
}

// A translation so long that determinants overflow, as sums of infinities of both signs.
TEST(DoublePairs, AreNotCertainAfterAnOverflow) {
    Mesh a, b;
    a.vertices = {{0, 0, 0}, {1e8, 0, 1e8}, {0, 1e8, 1e8}};
    b.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (Mesh* mesh : {&a, &b}) mesh->triangles = {{0, 1, 2}};
    for (const double x : {1e300, -1e300}) {
        Pose pose;
        pose.translation = {x, 1e300, 1e300};
        expect_exact(a, b, pose, {}, 1);
    }
}

}  // namespace
}  // namespace scb
