#include "core/packed/front_schedule.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "core/base/portable_math.h"
#include "scb/error.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

Mat3 turn_about(const Vec3& axis, double degrees) {
    const SinCos a = sin_cos_degrees(degrees);
    Mat3 across;
    across << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return Mat3::Identity() + a.sin * across + (1 - a.cos) * across * across;
}

/// A pose and one that is a turn and a step away from it, of any size.
std::pair<Pose, Pose> some_motion(Random& random) {
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(50)));
    const Pose from = random_pose(random, 2);
    const Pose moved{turn_about(random_unit_vector(random), 360 * size * random.uniform()),
                     random.below(2) == 0 ? Vec3(Vec3::Zero()) : Vec3(size * random_point(random))};
    return {from, compose(moved, from)};
}

TEST(DisplacementBound, HoldsForEveryPointOfTheBall) {
    Random random(91);
    double tightest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ball ball{3 * random_point(random), random.uniform(0, 1)};
        const auto [from, to] = some_motion(random);
        const double bound = displacement_bound(from, to, ball);
        for (int k = 0; k < 8; ++k) {
            const Vec3 p = ball.center + ball.radius * random_unit_vector(random);
            const double moved =
                std::sqrt(squared_norm(transform_point(to, p) - transform_point(from, p)));
            ASSERT_LE(moved, bound) << i;
            tightest = std::max(tightest, moved / bound);
        }
    }
    EXPECT_GT(tightest, 0.99);
}

TEST(DisplacementBound, IsExactForTranslations) {
    const Ball ball{{1, 2, 3}, 4};
    const Pose to{Mat3::Identity(), {3, 0, 4}};
    EXPECT_NEAR(displacement_bound({}, to, ball), 5, 1e-12);
    EXPECT_NEAR(displacement_bound({}, {}, ball), 0, 1e-12);
}

TEST(DisplacementBound, AllowsForPosesThatAreNotQuiteRigid) {
    Random random(92);
    for (int i = 0; i < 5'000; ++i) {
        const Ball ball{random_point(random), random.uniform(0, 1)};
        auto [from, to] = some_motion(random);
        for (int k = 0; k < 9; ++k) to.rotation(k / 3, k % 3) += 1e-10 * random.uniform(-1, 1);
        const double bound = displacement_bound(from, to, ball);
        for (int k = 0; k < 8; ++k) {
            const Vec3 p = ball.center + ball.radius * random_unit_vector(random);
            ASSERT_LE(std::sqrt(squared_norm(transform_point(to, p) - transform_point(from, p))),
                      bound);
        }
    }
    Pose mirrored;
    mirrored.rotation(0, 0) = -1;
    EXPECT_TRUE(std::isinf(displacement_bound({}, mirrored, {Vec3::Zero(), 1})));
}

TEST(MotionBound, HoldsForTheDistanceOfAnyTwoPoints) {
    Random random(93);
    for (int i = 0; i < 20'000; ++i) {
        const FrontBodies bodies = {{random_point(random), random.uniform(0, 1)},
                                    {random_point(random), random.uniform(0, 1)},
                                    0.1};
        const auto [from, to] = some_motion(random);
        const double bound = motion_bound(bodies, from, to);
        for (int k = 0; k < 8; ++k) {
            const Vec3 p = bodies.a.center + bodies.a.radius * random_unit_vector(random);
            const Vec3 q = bodies.b.center + bodies.b.radius * random_unit_vector(random);
            const double before = std::sqrt(squared_norm(p - transform_point(from, q)));
            const double after = std::sqrt(squared_norm(p - transform_point(to, q)));
            ASSERT_LE(std::abs(after - before), bound + 1e-14) << i;
        }
    }
}

// A is where it was, seen from B, to the last bit; but B's pose has become another stretch.
TEST(MotionBound, AllowsForPosesThatAreNotQuiteRigid) {
    Random random(94);
    for (int i = 0; i < 2'000; ++i) {
        const FrontBodies bodies = {
            {Vec3::Zero(), 0}, {100 * random_unit_vector(random), 0.1}, 0.1};
        const Pose from = random_pose(random, 2);
        Pose to = from;
        for (int k = 0; k < 9; ++k) to.rotation(k / 3, k % 3) += 1e-10 * random.uniform(-1, 1);
        to.translation =
            to.rotation.transpose().inverse() * (from.rotation.transpose() * from.translation);
        const Vec3 q = bodies.b.center;
        const double change = std::sqrt(squared_norm(transform_point(to, q))) -
                              std::sqrt(squared_norm(transform_point(from, q)));
        ASSERT_LE(std::abs(change), motion_bound(bodies, from, to)) << i;
    }
}

// A small body that turns about itself beside a large one moves little, whichever of them is B.
TEST(MotionBound, IsThatOfTheBodyThatMovesLess) {
    const Ball large{Vec3::Zero(), 100}, small{Vec3::Zero(), 1};
    const Pose from{Mat3::Identity(), {100, 0, 0}};
    const Pose to{turn_about(Vec3::UnitZ(), 1), {100, 0, 0}};
    const double degree = 3.14159265358979 / 180;
    EXPECT_NEAR(motion_bound({large, small, 0.1}, from, to), degree, 1e-5);
    EXPECT_NEAR(motion_bound({small, large, 0.1}, inverse(from), inverse(to)), degree, 1e-5);
}

}  // namespace
}  // namespace scb
