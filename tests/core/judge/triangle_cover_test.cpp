#include "core/judge/triangle_cover.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {
namespace {

using CoverKind = TriangleCover::Kind;

const TriangleCorners long_triangle = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 1, 0)};

TriangleCover cover(const std::vector<NodeVolume>& leaves, double tolerance = 1e-9) {
    std::vector<LeafWay> ways;
    for (const NodeVolume& leaf : leaves) ways.push_back({&leaf});
    return cover_of(long_triangle, ways, tolerance);
}

NodeVolume box(double from, double to, double top) {
    return box_between(Vec3(from, 0, 0), Vec3(to, top, 0));
}

TEST(TriangleCover, BoxesThatAreCutAtAPlaneCoverItTogether) {
    EXPECT_EQ(cover({box(0, 5, 1), box(5, 10, 0.5)}).kind, CoverKind::covered);
    EXPECT_EQ(cover({box(5, 10, 0.5), box(0, 5, 1)}).kind, CoverKind::covered);
    EXPECT_EQ(cover({box(0, 2, 1), box(2, 5, 0.8), box(5, 10, 0.5)}).kind, CoverKind::covered);
}

TEST(TriangleCover, APartThatIsInNoLeafIsFound) {
    const TriangleCover gap = cover({box(0, 4, 1), box(5, 10, 0.5)});
    EXPECT_EQ(gap.kind, CoverKind::open);
    EXPECT_GE(gap.point[0], 4);
    EXPECT_LE(gap.point[0], 5);
    EXPECT_GT(gap.amount, 0);
    // The box of the right part is too low where it begins.
    const TriangleCover low = cover({box(0, 5, 1), box(5, 10, 0.4)});
    EXPECT_EQ(low.kind, CoverKind::open);
    EXPECT_GT(low.amount, 0.05);
    EXPECT_LT(low.amount, 0.1);
    EXPECT_EQ(low.nearest, 1u);
    EXPECT_EQ(cover({box(0, 5, 1), box(5, 10, 0.4)}, 0.11).kind, CoverKind::covered);
}

TEST(TriangleCover, AllVolumesOnTheWayCount) {
    const NodeVolume left = box(0, 5, 1), right = box(5, 10, 0.5), above = box(0, 9, 1);
    const LeafWay through{&right, &above};
    const std::vector<LeafWay> ways{{&left}, through};
    const TriangleCover found = cover_of(long_triangle, ways, 1e-9);
    EXPECT_EQ(found.kind, CoverKind::open);
    EXPECT_NEAR(found.amount, 1, 1e-2);
}

// Leaves of each kind hold the two halves; a quarter less on one side leaves a part out.
TEST(TriangleCover, KnowsEachKindOfVolume) {
    const Vec3 left(2.5, 0.5, 0), right(7.5, 0.25, 0);
    const double of_left = std::hypot(2.5, 0.5), of_right = std::hypot(2.5, 0.25);
    const auto hull = [](const std::vector<Vec3>& points) -> NodeVolume {
        return std::make_shared<const Polytope>(Polytope{Vec3::Zero(), points, {}});
    };
    const Vec3 cut_low(5, 0, 0), cut_high(5, 0.5, 0);
    const Vec3 x = Vec3::UnitX();
    for (const double share : {1.0, 0.75}) {
        const std::vector<std::pair<NodeVolume, NodeVolume>> pairs = {
            {Ball{left, of_left}, Ball{right, share * of_right}},
            {Capsule{left, Vec3(2.5, 0, 0), 0.5}, Capsule{right, Vec3(2.5 * share, 0, 0), 0.25}},
            {Rss{left, {Vec3(2.5, 0, 0), Vec3(0, 0.5, 0)}, 0},
             Rss{right, {Vec3(2.5 * share, 0, 0), Vec3(0, 0.25, 0)}, 0}},
            {Scb{left, of_left, x, 2.5, -2.5}, Scb{right, of_right, x, 2.5 * share, -2.5}},
            {Scb2{left, of_left, {Slab{x, 2.5, -2.5}, Slab{Vec3::UnitY(), 1, -1}}},
             Scb2{right, of_right, {Slab{x, 2.5 * share, -2.5}, Slab{Vec3::UnitY(), 1, -1}}}},
            {hull({Vec3::Zero(), Vec3(0, 1, 0), cut_low, cut_high}),
             hull({cut_low, cut_high, Vec3(5 + 5 * share, 0, 0)})},
        };
        for (const auto& [of_a, of_b] : pairs) {
            SCOPED_TRACE(of_a.index());
            EXPECT_EQ(cover({of_a, of_b}, 1e-6).kind,
                      share == 1 ? CoverKind::covered : CoverKind::open);
        }
    }
}

TEST(TriangleCover, AHalfSpaceCoversItsHalf) {
    const NodeVolume above = OpenBox{Vec3(5, -HUGE_VAL, -HUGE_VAL), Vec3::Constant(HUGE_VAL)};
    EXPECT_EQ(cover({box(0, 5, 1), above}).kind, CoverKind::covered);
    EXPECT_EQ(cover({box(0, 4, 1), above}).kind, CoverKind::open);
}

// Random cuts by planes, and the boxes of the parts; one box that is a bit smaller leaves a gap.
TEST(TriangleCover, AgreesWithCutsAtRandomPlanes) {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        TriangleCorners t;
        for (Vec3& corner : t)
            for (int i = 0; i < 3; ++i) corner[i] = random.uniform(-1, 1);
        const int axis = static_cast<int>(random.next() % 3);
        const double least = std::min({t[0][axis], t[1][axis], t[2][axis]}),
                     most = std::max({t[0][axis], t[1][axis], t[2][axis]}),
                     at = least + (most - least) * random.uniform(0.2, 0.8);
        Vec3 lower[2], upper[2];
        for (int side = 0; side < 2; ++side) {
            lower[side].setConstant(HUGE_VAL);
            upper[side].setConstant(-HUGE_VAL);
            const auto add = [&](const Vec3& p) {
                lower[side] = lower[side].cwiseMin(p);
                upper[side] = upper[side].cwiseMax(p);
            };
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 &p = t[i], &q = t[(i + 1) % 3];
                if ((side == 0) == (p[axis] <= at)) add(p);
                if ((p[axis] - at) * (q[axis] - at) < 0)
                    add(p + (q - p) * ((at - p[axis]) / (q[axis] - p[axis])));
            }
        }
        const NodeVolume first = box_between(lower[0], upper[0]),
                         second = box_between(lower[1], upper[1]);
        const std::vector<LeafWay> ways{{&first}, {&second}};
        EXPECT_EQ(cover_of(t, ways, 1e-12).kind, CoverKind::covered) << round;
        upper[0][axis] -= 1e-3;
        const NodeVolume smaller = box_between(lower[0], upper[0]);
        const std::vector<LeafWay> gap{{&smaller}, {&second}};
        EXPECT_EQ(cover_of(t, gap, 1e-12).kind, CoverKind::open) << round;
    }
}

}  // namespace
}  // namespace scb
