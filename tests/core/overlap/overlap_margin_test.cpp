#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

// The farthest point of a slab cut ball in a direction.
Vec3 farthest_point(const Scb& s, const Vec3& d) {
    const double h = s.r * dot(s.n, d);
    if (s.f <= h && h <= s.e) return s.c + s.r * d;
    const double k = h > s.e ? s.e : s.f;
    const Vec3 along = d - dot(s.n, d) * s.n;
    const double length = along.norm();
    const Vec3 center = s.c + k * s.n;
    if (length < 1e-8) return center;
    return center + std::sqrt(std::max(0.0, (s.r - k) * (s.r + k))) / length * along;
}

TEST(ClosedScbs, OverlapWhereTheyTouchByHand) {
    const auto expect_touching = [](const Scb& a, const Scb& b) {
        for (const OverlapTest test : sound_tests) {
            expect_stage(a, b, Stage::overlapping, test, 0.0);
            expect_stage(b, a, Stage::overlapping, test, 0.0);
            expect_stage(flipped(a), b, Stage::overlapping, test);
            expect_stage(a, flipped(b), Stage::overlapping, test);
        }
    };
    const Scb plate = slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.25);
    expect_touching(whole_ball_at({0, 0, 0}, 1), whole_ball_at({0, 3, 4}, 4));   // balls
    expect_touching(plate, slab_at({2, 0, 0}, 1, unit_z, 0.25, -0.25));          // zones
    expect_touching(plate, whole_ball_at({0.5, 0, 1.25}, 1));                    // plane, ball
    expect_touching(plate, whole_ball_at({0.5, 0, -1.25}, 1));                   //
    expect_touching(plate, slab_at({0.5, 0.5, 0.5}, 1, unit_z, 0.25, -0.25));    // planes
    expect_touching(plate, slab_at({0.5, 0.5, -0.5}, 1, -unit_z, 0.25, -0.25));  //
    expect_touching(plate, slab_at({0.5, 0, 1.25}, 1, unit_x, 0.5, -0.25));      // plane, zone
    expect_touching(slab_at({0, 0, 0}, 5, unit_z, 3, -1),
                    slab_at({8, 0, 6}, 5, unit_z, 0, -3));  // rims
    expect_touching(slab_at({0, 0, 0}, 1, unit_z, 0, 0),
                    slab_at({2, 0, 0}, 1, unit_z, 0, 0));                       // discs
    expect_touching(whole_ball_at({0, 0, 0}, 0), whole_ball_at({0, 0, 0}, 0));  // points
    expect_touching(slab_at({0, 0, 0}, 1, unit_z, 1, 1), slab_at({0, 0, 2}, 1, unit_z, -1, -1));
    expect_touching(slab_at({0, 0, 0}, 1, unit_z, 0.5, 0.25),
                    slab_at({0, 0, 0}, 1, unit_z, 0.25, -1));
}

// B is made to touch A in one point and to lie on the other side of a plane there.
TEST(ClosedScbs, OverlapWhereTheyTouchAnywhere) {
    Random random(12);
    for (int i = 0; i < 20000; ++i) {
        VolumePair<Scb> pair = random_scb_pair(random);
        Scb b = placed(pair.b, pair.b_to_a);
        Vec3 d = random_unit_vector(random);
        const std::uint32_t kind = random.below(4);
        if (kind == 0) d = pair.a.n;
        if (kind == 1) d = -b.n;
        b.c += farthest_point(pair.a, d) - farthest_point(b, -d);
        const double away = random.below(4) == 0 ? 1000 : 1;
        const Pose world_a = random_pose(random, away), world_b = random_pose(random, away);
        pair.b_to_a = relative_pose(world_a, world_b);
        pair.a = placed(pair.a, inverse(world_a));
        pair.b = placed(b, inverse(world_b));
        for (const OverlapTest test : sound_tests)
            for (const double threshold : {0.0, 0.7})
                ASSERT_EQ(stage_name(stage_of_pair(pair, test, threshold)), "overlapping")
                    << overlap_test_name(test) << ", pair " << i;
    }
}

TEST(ClosedBallsAndBoxes, OverlapWhereTheyTouch) {
    Random random(13);
    for (int i = 0; i < 20000; ++i) {
        const Pose world_a = random_pose(random, 3), world_b = random_pose(random, 3);
        const Pose pose = relative_pose(world_a, world_b);
        const Vec3 d = random_unit_vector(random);
        const Ball a{random_point(random), random.uniform(0, 1)};
        Ball b{{}, random.uniform(0, 1)};
        b.center = a.center + (a.radius + b.radius) * d;
        ASSERT_EQ(overlap(placed(a, inverse(world_a)), placed(b, inverse(world_b)), pose),
                  Stage::overlapping);

        // Supporting corners: a face, an edge or a corner of A on one of B.
        Obb p{random_point(random), random_rotation(random),
              random_point(random).cwiseAbs().cwiseMax(0.05)},
            q = p;
        if (random.below(3) != 0) q.axes = random_rotation(random);
        q.half = random_point(random).cwiseAbs();
        if (random.below(4) == 0) q.half[random.below(3)] = 0;
        Vec3 axis = d;
        const int u = static_cast<int>(random.below(3)), v = static_cast<int>(random.below(3));
        const std::uint32_t kind = random.below(4);
        if (kind == 0) axis = p.axes.col(u);
        if (kind == 1) axis = q.axes.col(u);
        if (kind == 2) axis = cross(Vec3(p.axes.col(u)), Vec3(q.axes.col(v)));
        if (axis.norm() < 0.1) continue;
        axis.normalize();
        const auto corner = [](const Obb& box, const Vec3& direction) {
            Vec3 c = box.center;
            for (int k = 0; k < 3; ++k)
                c += (dot(Vec3(box.axes.col(k)), direction) > 0 ? 1 : -1) * box.half[k] *
                     box.axes.col(k);
            return c;
        };
        q.center += corner(p, axis) - corner(q, -axis);
        ASSERT_EQ(
            stage_name(overlap(placed(p, inverse(world_a)), placed(q, inverse(world_b)), pose)),
            "overlapping");
    }
}

TEST(Placement, LeavesAMarginOfSome1eMinus14OfTheLengths) {
    Random random(24);
    for (int i = 0; i < 1000; ++i) {
        Pose pose = random_pose(random, 5);
        const double a = random.uniform(0, 9), b = random.uniform(0, 9);
        const double lengths = a + b + pose.translation.norm();
        EXPECT_GT(placement(pose, a, b).margin, 7e-15 * lengths);
        EXPECT_LT(placement(pose, a, b).margin, 2e-14 * lengths);
        // A pose that is just not refused stretches B.
        pose.rotation.col(1) *= 1 + 4e-10;
        EXPECT_GT(placement(pose, a, b).margin, 4e-10 * b);
    }
}

TEST(Overlap, RejectsWhatIsApartByMuchLessThanItsSize) {
    for (const double gap : {1e-12, 1e-6}) {
        const Scb a = slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.25);
        const Scb b = slab_at({0.1, 0, 0.5 + gap}, 1, unit_z, 0.25, -0.25);
        // The bound of the sine of parallel normals is 6e-8, so a gap below it is not seen.
        for (const OverlapTest test : slab_cylinder_tests)
            expect_stage(a, b, gap > 1e-7 ? Stage::slab_cylinder : Stage::overlapping, test);
        expect_stage(Ball{{0, 0, 0}, 1}, Ball{{2 + gap, 0, 0}, 1}, Stage::ball_ball);
        expect_stage(whole_ball_at({0, 0, 1.25 + gap}, 1),
                     slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.25), Stage::ball_slab,
                     OverlapTest::symmetric);
        Obb p{{0, 0, 0}, Mat3::Identity(), {1, 1, 1}}, q = p;
        q.center[0] = 2 + gap;
        expect_stage(p, q, Stage::axis_a0);
    }
}

}  // namespace
}  // namespace scb
