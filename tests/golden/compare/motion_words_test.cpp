#include "golden/compare/motion_words.h"

#include <gtest/gtest.h>

#include "scenes/scene/motion.h"

namespace scb::golden {
namespace {

Pose pose(const Vec3& translation, double degrees = 0) {
    return {scenes::rotation_about(Vec3(1, 2, 3), degrees), translation};
}

TEST(MotionWords, SayHowFarABodyMovedAndTurned) {
    const Pose start = pose({1, 2, 3}, 20);
    EXPECT_EQ(motion_words(start, start), "");
    EXPECT_EQ(motion_words(start, pose({1.02, 2, 3}, 20)), "moved: 0.02 along x");
    EXPECT_EQ(motion_words(start, pose({1.02, 2, 2}, 21.5)),
              "moved: 0.02 along x, -1 along z, 1.5 degrees");
    EXPECT_EQ(motion_words(start, pose({1, 2, 3}, 21)), "turned: 1 degree");
    EXPECT_EQ(motion_words(start, pose({1, 2, 3}, 200)), "turned: 180 degrees");
    EXPECT_EQ(motion_words(start, pose({1, 2, 3}, 20.0001)), "turned: 0.0001 degrees");
}

TEST(MotionWords, LeaveOutRoundingBesideAMotionButNotAlone) {
    const Pose start = pose({1, 2, 3}, 20);
    EXPECT_EQ(motion_words(start, pose({1.02, 2 + 1e-15, 3}, 20 + 1e-11)), "moved: 0.02 along x");
    EXPECT_EQ(motion_words(pose({0, 0, 0}), pose({0, 1e-15, 0})), "moved: 1e-15 along y");
}

}  // namespace
}  // namespace scb::golden
