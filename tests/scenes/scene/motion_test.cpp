#include "scenes/scene/motion.h"

#include <cmath>
#include <limits>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

void expect_near(const Mat3& a, const Mat3& b, double tolerance) {
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), tolerance) << a << "\n\n" << b;
}

TEST(Motion, WithoutAnythingIsTheIdentityAtEveryFrame) {
    for (const int frame : {0, 1, 499}) {
        const Pose pose = pose_at({}, frame);
        EXPECT_EQ(pose.rotation, Mat3(Mat3::Identity()));
        EXPECT_EQ(pose.translation, Vec3(0, 0, 0));
    }
}

TEST(Motion, TurnsCounterclockwiseSeenFromTheTipOfTheAxis) {
    Mat3 z90, x90;
    z90 << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    x90 << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    EXPECT_EQ(rotation_about(Vec3(0, 0, 5), 90), z90);
    EXPECT_EQ(rotation_about(Vec3(2, 0, 0), 90), x90);
    EXPECT_EQ(rotation_about(Vec3(0, 0, -1), 270), z90);
    Mat3 third;  // a third of a turn about (1, 1, 1) takes x to y, y to z, z to x
    third << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    expect_near(rotation_about(Vec3(1, 1, 1), 120), third, 1e-15);
}

TEST(Motion, TakesAxesOfAnyLength) {
    const Mat3 turn = rotation_about(Vec3(1, 2, 3), 33);
    expect_near(rotation_about(Vec3(1e-200, 2e-200, 3e-200), 33), turn, 1e-15);
    expect_near(rotation_about(Vec3(1e200, 2e200, 3e200), 33), turn, 1e-15);
    EXPECT_THROW(rotation_about(Vec3(0, 0, 0), 1), InputError);
    EXPECT_THROW(rotation_about(Vec3(1, 0, 0), std::numeric_limits<double>::infinity()),
                 InputError);
}

TEST(Motion, AppliesTurnsInTheOrderOfTheList) {
    Motion motion;
    motion.turns = {{Vec3::UnitX(), 90, 0}, {Vec3::UnitZ(), 90, 0}};
    const Pose pose = pose_at(motion, 0);
    // y goes to z by the first turn and stays there; z goes to -y, then to x.
    EXPECT_EQ(transform_direction(pose, Vec3::UnitY()), Vec3(0, 0, 1));
    EXPECT_EQ(transform_direction(pose, Vec3::UnitZ()), Vec3(1, 0, 0));
}

TEST(Motion, AddsDegreesPerFrame) {
    Motion motion;
    motion.turns = {{Vec3::UnitZ(), 30, 0.5}};
    expect_near(pose_at(motion, 120).rotation, rotation_about(Vec3::UnitZ(), 90), 1e-15);
}

TEST(Motion, MovesOnAStraightLineBeyondItsEnd) {
    Motion motion;
    motion.path = {{0.05, 0.9, 0.03}, {0.05, -0.9, 0.03}, 499};
    EXPECT_EQ(pose_at(motion, 0).translation, Vec3(0.05, 0.9, 0.03));
    EXPECT_NEAR(pose_at(motion, 499).translation[1], -0.9, 1e-15);
    EXPECT_NEAR(pose_at(motion, 998).translation[1], -2.7, 1e-14);
}

TEST(Motion, BringsTheBenchmarkSpheresTogetherAtFrame250) {
    Motion a, b;
    a.path = {{-1, 0, 0}, {1, 0, 0}, 500};
    b.path = {{1, 0, 0}, {-1, 0, 0}, 500};
    EXPECT_EQ(pose_at(a, 250).translation, Vec3(0, 0, 0));
    EXPECT_EQ(pose_at(b, 250).translation, Vec3(0, 0, 0));
    for (int i = 0; i < 500; ++i) {
        EXPECT_EQ(pose_at(a, i).translation[0], -1 + i / 250.0);
        EXPECT_EQ(pose_at(b, i).translation[0], 1 - i / 250.0);
    }
}

TEST(Motion, ExpressesTheEulerIncrementsOfTheHorses) {
    Motion motion;
    motion.turns = {{Vec3::UnitX(), 10, 0.9}, {Vec3::UnitY(), 0, 1.3}, {Vec3::UnitZ(), 0, 0.7}};
    const int i = 123;
    const Mat3 x = rotation_about(Vec3::UnitX(), 0.9 * i + 10),
               y = rotation_about(Vec3::UnitY(), 1.3 * i),
               z = rotation_about(Vec3::UnitZ(), 0.7 * i);
    expect_near(pose_at(motion, i).rotation, z * y * x, 1e-15);
}

TEST(Motion, StaysRigidOverAMillionFrames) {
    Motion motion;
    motion.turns = {{Vec3(1, 2, 3), 10, 0.9}, {Vec3(3, -1, 2), 0, -1.3}, {Vec3(1, 1, 0.3), 0, 0.7}};
    for (int i = 0; i < 1000000; i += 9973) EXPECT_LT(rigidity_defect(pose_at(motion, i)), 1e-14);
}

TEST(Motion, RefusesAPoseThatIsNotRigid) {
    Motion motion;
    motion.base = 2 * Mat3::Identity();
    expect_in("not rigid", refusal([&] { pose_at(motion, 0); }));
}

}  // namespace
}  // namespace scb::scenes
