#include <gtest/gtest.h>

#include <algorithm>

#include "core/judge/mapped_volume.h"
#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/recordings/body_pose.h"
#include "scenes/scene/motion.h"
#include "scenes/scene/pose_rows.h"
#include "tests/scenes/recordings/judged_recordings.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

TEST(BodyPose, OfRoundedNumbersIsRigid) {
    Pose told;
    told.rotation = rotation_about({1, 2, -1}, 40).cast<float>().cast<double>();
    const BodyPose body = body_pose(told);
    EXPECT_GT(body.defect, 1e-9) << "as it was recorded";
    EXPECT_LT(body.defect, 1e-6);
    const Mat3 product = body.pose.rotation.transpose() * body.pose.rotation;
    EXPECT_LT((product - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((body.pose.rotation - told.rotation).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_FALSE(body.is_stretched());
}

TEST(BodyPose, ThatMirrorsIsARotationAfterAMirror) {
    const Mat3 rotation = rotation_about({1, 2, -1}, 40);
    Pose told;
    told.rotation = rotation * Vec3(2, -2, 2).asDiagonal();
    const BodyPose body = body_pose(told);
    EXPECT_EQ(body.pose_fault, "");
    EXPECT_GT(determinant(body.pose.rotation), 0.999);
    EXPECT_EQ(stretch_words(body.stretch), "scaled by 2 and mirrored");
    const Mat3 again = body.pose.rotation * body.stretch;
    EXPECT_LT((again - told.rotation).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(JudgedPoses, NamesNodesOfBThatStandBeforeThoseOfA) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    for (Record& record : records)
        if (auto* event = std::get_if<RecordedEvent>(&record)) std::swap(event->a, event->b);
    const RecordingJudgement judged = judge(records);
    ASSERT_FALSE(judged.poses.empty());
    EXPECT_NE(judged.poses[0].pose.find("in the other order than the query"), std::string::npos);
}

TEST(JudgedPoses, NamesThePoseThatTheTestsFit) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    // B's poses come one frame late.
    const std::vector<RecordedPose*> poses = poses_of_b(records);
    ASSERT_EQ(poses.size(), 3u);
    poses[0]->rows = poses[1]->rows;
    poses[1]->rows = poses[2]->rows;
    poses[2]->rows[3] -= 0.15;
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.poses.size(), 2u);
    for (const PoseProblem& problem : judged.poses) {
        EXPECT_EQ(problem.pose, "the pose of the frame before");
        EXPECT_GT(problem.told.wrong, 0u);
    }
    EXPECT_EQ(judged.poses[0].query.frame, 3);
}

// What fits one query of three is chance.
TEST(JudgedPoses, APoseThatFitsOneQueryOfSeveralIsNotNamed) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    const auto turn = [](RecordedPose& pose) {
        for (double& number : pose.rows) number = 0;
        pose.rows[2] = pose.rows[4] = pose.rows[9] = 1;
        pose.rows[3] = 0.05;
    };
    const std::vector<RecordedPose*> poses = poses_of_b(records);
    ASSERT_EQ(poses.size(), 3u);
    poses[0]->rows = poses[1]->rows;  // the pose of the second frame fits, one frame late
    turn(*poses[1]);
    poses[2]->rows[11] += 0.2;
    const RecordingJudgement judged = judge(records);
    std::uint64_t erring = 0;
    for (const FrameJudgement& frame : judged.frames) erring += frame.wrong > 0;
    EXPECT_GE(erring, 2u);
    EXPECT_TRUE(judged.poses.empty()) << judged.poses[0].pose;
}

TEST(JudgedPoses, NamesAWorldRotationThatIsTransposed) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    // Both bodies are turned together, which changes nothing; then the file has B's the wrong way.
    Pose turn;
    turn.rotation << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
    const auto turned = [&](const PoseRows& rows) {
        return rows_of(relative_pose(turn, pose_of(rows)));
    };
    for (Record& record : records)
        if (auto* pose = std::get_if<RecordedPose>(&record)) {
            pose->rows = turned(pose->rows);
            if (pose->body == 1)
                for (const auto& [i, j] : {std::pair(1, 4), std::pair(2, 8), std::pair(6, 9)})
                    std::swap(pose->rows[static_cast<std::size_t>(i)],
                              pose->rows[static_cast<std::size_t>(j)]);
        }
    const RecordingJudgement judged = judge(records);
    ASSERT_FALSE(judged.poses.empty());
    EXPECT_EQ(judged.poses[0].pose, "the poses with the rotation of B transposed");
}

// The engine tests volumes with the poses of the frame before, and triangles with the right poses.
TEST(JudgedPoses, NamesThePoseOfTheTestsOfVolumesAlone) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    const std::vector<RecordedPose*> poses = poses_of_b(records);
    ASSERT_EQ(poses.size(), 3u);
    poses[0]->rows = poses[1]->rows;
    poses[1]->rows = poses[2]->rows;
    poses[2]->rows[3] -= 0.15;
    Pose told;
    for (Record& record : records) {
        if (const auto* pose = std::get_if<RecordedPose>(&record); pose && pose->body == 1)
            told = pose_of(pose->rows);
        auto* event = std::get_if<RecordedEvent>(&record);
        if (!event || (event->tag != items_apart && event->tag != items_meet)) continue;
        const bool meet =
            triangles_overlap(corners(mesh_a().mesh, event->a),
                              transform_corners(told, corners(mesh_b().mesh, event->b)));
        event->tag = meet ? items_meet : items_apart;
    }
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.poses.size(), 2u);
    for (const PoseProblem& problem : judged.poses) {
        EXPECT_TRUE(problem.only_volumes);
        EXPECT_EQ(problem.pose, "the pose of the frame before");
        EXPECT_EQ(problem.told.wrong_items, 0u);
    }
}

TEST(JudgedPoses, SaysThatBodiesHaveMovedWithinAFrame) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    bool first = true;
    std::erase_if(records, [&](const Record& record) {
        return std::holds_alternative<RecordedFrame>(record) && !std::exchange(first, false);
    });
    const RecordingJudgement judged = judge(records);
    EXPECT_FALSE(judged.wrong());
    ASSERT_EQ(judged.notes.size(), 1u);
    EXPECT_NE(judged.notes[0].find("were queried at several poses"), std::string::npos);
    EXPECT_TRUE(judge(recording_of(trace_of(VolumeKind::obb))).notes.empty());
}

TEST(JudgedPoses, SaysThatNoPoseWasTold) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    std::erase_if(
        records, [](const Record& record) { return std::holds_alternative<RecordedPose>(record); });
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.wrong());
    ASSERT_EQ(judged.notes.size(), 1u);
    EXPECT_NE(judged.notes[0].find("have no recorded pose"), std::string::npos);
}

TEST(JudgedPoses, AQueryWithoutAPoseIsNotJudged) {
    for (const double number : {0.0, double{NAN}}) {
        std::vector<Record> records = two_balls();
        RecordedPose pose = pose_at(1, 0);
        pose.rows[0] = number;
        records.emplace_back(pose);
        append(records, query_with({{1, 0, 0}}));
        const RecordingJudgement judged = judge(records);
        EXPECT_EQ(judged.frames.at(0).queries, 1u);
        EXPECT_EQ(judged.frames.at(0).volume_tests, 0u);
        // A flat body is a map that this project does not judge; no number is an error.
        EXPECT_EQ(judged.verdict(), number == 0 ? Verdict::partly_judged : Verdict::wrong);
    }
}

TEST(JudgedPoses, AScaledBodyIsJudgedWithItsScale) {
    // Balls of radius 1 that stand 2.5 apart: they meet where the second is scaled by 2.
    for (const double scale : {1.0, 2.0, -2.0}) {
        std::vector<Record> records = two_balls();
        RecordedPose pose = pose_at(1, 2.5);
        for (const std::size_t i : {0u, 5u, 10u}) pose.rows[i] = scale;
        records.emplace_back(pose);
        append(records, query_with({{1, 0, 0}}));
        const RecordingJudgement judged = judge(records);
        EXPECT_EQ(judged.wrong(), scale != 1) << scale;
        ASSERT_EQ(judged.stretches.size(), scale == 1 ? 0u : 1u);
        if (scale != 2) continue;
        EXPECT_EQ(judged.stretches[0], "B is scaled by 2 by its pose at frame 0, and judged so");
    }
}

// Each pose that moves the two apart explains that one test.
TEST(JudgedPoses, APoseIsNotNamedForTestsOfOneOutcome) {
    std::vector<Record> records = two_balls();
    // The pose of the frame before would explain it, as any pose of bodies that are apart.
    append(records, {RecordedFrame{0}, pose_at(0, 0), pose_at(1, 5)});
    append(records, query_with({{1, 0, 0}}));
    append(records, {RecordedFrame{1}, pose_at(1, 1.5)});
    append(records, query_with({{1, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.test_problems.size(), 1u);
    EXPECT_TRUE(judged.poses.empty());
}

}  // namespace
}  // namespace scb::scenes
