#include "golden/compare/cause.h"

#include <gtest/gtest.h>

#include "scenes/scene/motion.h"

namespace scb::golden {
namespace {

CaseRecord record() {
    CaseRecord record;
    record.command = "scb render pairs scene.json --frames 100 --size 320x240";
    record.meshes = {{"A", {1280, 642, "a"}}, {"B", {20, 12, "b"}}};
    record.poses = {{100, {{"A", Pose{}}, {"B", Pose{}}}}};
    record.settings = {{"scene", "spheres"}, {"test", "corrected"}, {"threshold", "0.7"}};
    return record;
}

std::string cause(const CaseRecord& before, const CaseRecord& after) {
    return cause_of(before, after).sentences;
}

TEST(Cause, IsTheBodyThatMoved) {
    CaseRecord after = record();
    after.poses[100]["B"].translation = {0.02, 0, 0};
    EXPECT_EQ(cause(record(), after), "Body B moved: 0.02 along x.");
    EXPECT_EQ(cause(after, record()), "Body B moved: -0.02 along x.");
}

TEST(Cause, NamesTheFrameWhereOthersAreOtherwise) {
    CaseRecord before = record();
    before.poses[400] = before.poses[100];
    CaseRecord after = before;
    after.poses[400]["B"].translation = {0, 0, 3};
    EXPECT_EQ(cause(before, after), "In frame 400, body B moved: 3 along z.");
    after.poses[100]["B"] = after.poses[400]["B"];
    EXPECT_EQ(cause(before, after), "Body B moved: 3 along z.");
    // Of other frames nothing is known.
    before.poses.clear();
    EXPECT_EQ(cause(before, after), "");
}

TEST(Cause, IsTheMeshThatChanged) {
    CaseRecord after = record();
    after.meshes["A"] = {320, 162, "x"};
    EXPECT_EQ(cause(record(), after),
              "The mesh of body A changed: 320 triangles instead of 1,280.");
    EXPECT_TRUE(cause_of(record(), after).other_meshes);
    after.meshes["A"] = {1280, 640, "x"};
    EXPECT_EQ(cause(record(), after), "The mesh of body A changed: 640 vertices instead of 642.");
    after.meshes["A"] = {1280, 642, "x"};
    EXPECT_EQ(cause(record(), after),
              "The mesh of body A changed: as many triangles and vertices, but not the same.");
    after.meshes["B"] = {20, 12, "x"};
    EXPECT_EQ(cause(record(), after),
              "The meshes of bodies A and B changed: as many triangles and vertices, but not the "
              "same.");
    after = record();
    after.meshes.erase("A");
    after.meshes["C"] = {};
    EXPECT_EQ(cause(record(), after), "Body A is gone. Body C is new.");
}

TEST(Cause, IsTheSettingThatChanged) {
    CaseRecord after = record();
    after.settings = {{"scene", "spheres"}, {"test", "symmetric"}};
    after.command += " --test symmetric";
    EXPECT_EQ(cause(record(), after), "The overlap test changed: symmetric instead of corrected.");
    after.settings["scene"] = "knots";
    after.poses[100]["B"].translation = {0.02, 0, 0};  // of another body
    EXPECT_EQ(cause(record(), after),
              "The scene changed: knots instead of spheres. "
              "The overlap test changed: symmetric instead of corrected.");
}

TEST(Cause, QuotesWhatElseOfTheCommandChanged) {
    CaseRecord after = record();
    after.command = "scb render pairs scene.json --frames 120 --size 320x240";
    EXPECT_EQ(cause(record(), after),
              "The command changed: `--frames 120` instead of `--frames 100`.");
    after.command = record().command + " --no-leaves";
    EXPECT_EQ(cause(record(), after), "The command changed: `--no-leaves` is new.");
    EXPECT_EQ(cause(after, record()), "The command changed: `--no-leaves` is gone.");
    after.settings.clear();
    EXPECT_EQ(cause(after, record()), "");
}

TEST(Cause, IsNotGuessed) {
    EXPECT_EQ(cause(record(), record()), "");
    EXPECT_EQ(cause({}, record()), "");
    EXPECT_FALSE(cause_of({}, record()).has_settings);
    EXPECT_TRUE(cause_of(record(), record()).has_settings);
}

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
