#include "scenes/recordings/recording_judgement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/analysis/attribution.h"
#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/recordings/trace_recording.h"
#include "scenes/scene/pose_rows.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

const BuiltMesh& mesh_a() {
    static const BuiltMesh built(random_soup(1, 120, 0.15));
    return built;
}
const BuiltMesh& mesh_b() {
    static const BuiltMesh built(random_soup(2, 100, 0.15));
    return built;
}

Trace trace_of(VolumeKind volume, OverlapTest test = OverlapTest::corrected) {
    return record_trace(mesh_a(), mesh_b(), asking(volume, test), {0, 3, 6});
}

std::string recording_of(const Trace& trace) {
    const auto kind = static_cast<std::size_t>(trace.header.volume);
    TraceRecording recording(trace.header, {&mesh_a().mesh, &mesh_b().mesh},
                             {&mesh_a().hierarchies[kind], &mesh_b().hierarchies[kind]});
    for (const TraceFrame& frame : trace.frames) recording.add(frame, {Pose{}, frame.b_to_a});
    return recording.finish();
}

std::vector<Record> records_in(const std::string& bytes) {
    std::vector<Record> records;
    RecordingReader reader(bytes, "test");
    while (const Record* record = reader.next()) records.push_back(*record);
    return records;
}

constexpr auto items_apart = static_cast<std::uint8_t>(RecordTag::items_apart),
               items_meet = static_cast<std::uint8_t>(RecordTag::items_meet),
               a_pair = static_cast<std::uint8_t>(RecordTag::pair);

std::vector<RecordedPose*> poses_of_b(std::vector<Record>& records) {
    std::vector<RecordedPose*> poses;
    for (Record& record : records)
        if (auto* pose = std::get_if<RecordedPose>(&record); pose && pose->body == 1)
            poses.push_back(pose);
    return poses;
}

RecordingJudgement judge(const std::string& bytes) {
    return judge_recording(
        bytes, "test.scbrec", [](int) { return true; }, [] { return true; });
}

RecordingJudgement judge(const std::vector<Record>& records) {
    RecordingWriter writer;
    for (const Record& record : records) writer.add(record);
    return judge(writer.finish());
}

/// Both meshes are told anew at each frame, by two frames of which one query is judged.
TEST(RecordingJudgement, OfMeshesThatAreToldAnewTheNewOnesHold) {
    std::vector<Record> records, single;
    std::array<RecordedMesh, 2> meshes;
    for (const Record& record : records_in(recording_of(trace_of(VolumeKind::obb)))) {
        if (const auto* mesh = std::get_if<RecordedMesh>(&record)) meshes[mesh->mesh] = *mesh;
        if (std::holds_alternative<RecordedQuery>(record))
            for (RecordedMesh& mesh : meshes) {
                // A vertex that no triangle has changes the mesh, and nothing else.
                mesh.coordinates.insert(mesh.coordinates.end(), {0, 0, 0});
                records.push_back(mesh);
            }
        records.push_back(record);
    }
    const RecordingJudgement judged = judge(records);
    EXPECT_FALSE(judged.wrong());
    ASSERT_EQ(judged.frames.size(), 3u);
    EXPECT_EQ(judged.exact_pairs, judge(recording_of(trace_of(VolumeKind::obb))).exact_pairs);
}

TEST(RecordingJudgement, AMeshThatWasNotToldIsOdd) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    std::erase_if(records, [](const Record& record) {
        const auto* mesh = std::get_if<RecordedMesh>(&record);
        return mesh != nullptr && mesh->mesh == 1;
    });
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.wrong());
    ASSERT_EQ(judged.odd.size(), 1u);
    EXPECT_NE(judged.odd[0].find("tree 1 is of mesh 1, which was not told"), std::string::npos);
}

TEST(RecordingJudgement, NamesNodesOfBThatStandBeforeThoseOfA) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    for (Record& record : records)
        if (auto* event = std::get_if<RecordedEvent>(&record)) std::swap(event->a, event->b);
    const RecordingJudgement judged = judge(records);
    ASSERT_FALSE(judged.poses.empty());
    EXPECT_NE(judged.poses[0].pose.find("the other way round than the query"), std::string::npos);
}

TEST(RecordingJudgement, FindsNothingWrongWithOwnQueries) {
    // Sanitized: slab cut balls, boxes along the axes, rectangle swept spheres.
    for (std::size_t k = 0; k < all_volume_kinds().size();
         k += unless_sanitized<std::size_t>(1, 5)) {
        const VolumeKind volume = all_volume_kinds()[k];
        SCOPED_TRACE(volume_kind_name(volume));
        const Trace trace = trace_of(volume);
        const RecordingJudgement judged = judge(recording_of(trace));
        EXPECT_FALSE(judged.wrong());
        EXPECT_EQ(judged.trees.size(), 2u);
        EXPECT_EQ(judged.trees[0].nodes, 2 * mesh_a().mesh.triangles.size() - 1);
        EXPECT_EQ(judged.unjudged, 0u);
        std::uint64_t pairs = 0, tests = 0;
        for (const TraceFrame& frame : trace.frames) pairs += frame.found.pairs.size();
        for (const FrameJudgement& frame : judged.frames) tests += frame.pairs;
        EXPECT_GT(pairs, 0u);
        EXPECT_EQ(tests, pairs);
        EXPECT_EQ(judged.exact_pairs, pairs);
    }
}

TEST(RecordingJudgement, CountsWasteAsTheAttributionOfOwnQueriesDoes) {
    for (const VolumeKind volume : {VolumeKind::scb, VolumeKind::scb2, VolumeKind::obb,
                                    VolumeKind::aabb, VolumeKind::dop18, VolumeKind::rss}) {
        SCOPED_TRACE(volume_kind_name(volume));
        const Trace trace = trace_of(volume);
        const auto kind = static_cast<std::size_t>(volume);
        PassCounts sum;
        for (const TraceFrame& frame : trace.frames)
            sum += attribute(mesh_a().hierarchies[kind], mesh_b().hierarchies[kind], trace.header,
                             frame, traversal_tree(trace.header, frame), frame.found.pairs)
                       .counts;
        const RecordingJudgement judged = judge(recording_of(trace));
        EXPECT_EQ(judged.wasted_loose + judged.wasted_weak,
                  sum.wasted.volume_tests + sum.wasted.triangle_tests);
        EXPECT_GT(judged.wasted_loose, 0u);
        EXPECT_EQ(judged.stages[0].false_positives, sum.passed(PassReason::weak_test));
    }
}

TEST(RecordingJudgement, NamesTheWrongRejectionsOfThePrintedTest) {
    // Line 8 of Figure 8 as it is printed rejects some volumes that overlap.
    const Trace trace = trace_of(VolumeKind::scb, OverlapTest::printed);
    const RecordingJudgement judged = judge(recording_of(trace));
    std::uint64_t wrong = 0, wrongly_rejected = 0;
    for (const FrameJudgement& frame : judged.frames) wrong += frame.wrong;
    for (const TraceFrame& frame : trace.frames)
        wrongly_rejected += attribute(mesh_a().hierarchies[0], mesh_b().hierarchies[0],
                                      trace.header, frame, traversal_tree(trace.header, frame), {})
                                .wrongly_rejected.size();
    EXPECT_EQ(wrong, wrongly_rejected);
}

TEST(RecordingJudgement, NamesThePoseThatTheTestsFit) {
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
TEST(RecordingJudgement, APoseThatFitsOneQueryOfSeveralIsNotNamed) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    const auto turn = [](RecordedPose& pose) {
        for (double& number : pose.rows) number = 0;
        pose.rows[2] = pose.rows[4] = pose.rows[9] = 1;
        pose.rows[3] = 0.05;
    };
    const std::vector<RecordedPose*> poses = poses_of_b(records);
    ASSERT_EQ(poses.size(), 3u);
    poses[0]->rows = poses[1]->rows;  // that of the second fits, one frame late
    turn(*poses[1]);
    poses[2]->rows[11] += 0.2;
    const RecordingJudgement judged = judge(records);
    std::uint64_t erring = 0;
    for (const FrameJudgement& frame : judged.frames) erring += frame.wrong > 0;
    EXPECT_GE(erring, 2u);
    EXPECT_TRUE(judged.poses.empty()) << judged.poses[0].pose;
}

TEST(RecordingJudgement, NamesAWorldRotationThatIsTransposed) {
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

// Its tests of volumes are made with the poses of the frame before, those of triangles are not.
TEST(RecordingJudgement, NamesThePoseOfTheTestsOfVolumesAlone) {
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

TEST(RecordingJudgement, SaysThatBodiesHaveMovedWithinAFrame) {
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

TEST(RecordingJudgement, SaysThatNoPoseWasTold) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    std::erase_if(
        records, [](const Record& record) { return std::holds_alternative<RecordedPose>(record); });
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.wrong());
    ASSERT_EQ(judged.notes.size(), 1u);
    EXPECT_NE(judged.notes[0].find("no pose was told"), std::string::npos);
}

TEST(RecordingJudgement, AToldToleranceHoldsHoweverLargeTheVolumesAre) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::aabb)));
    records.insert(records.begin(), RecordedSetting{"tolerance", "1e-9"});
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (auto* node = std::get_if<RecordedNode>(&records[i]); node && node->node == 0)
            for (std::size_t k = 0; k < 6; ++k) node->volume.values[k] = k < 3 ? -1e7 : 1e7;
        if (auto* event = std::get_if<RecordedEvent>(&records[i]);
            event && event->tag == items_meet)
            event->tag = items_apart;
    }
    std::erase_if(records, [](const Record& record) {
        const auto* event = std::get_if<RecordedEvent>(&record);
        return event && event->tag == a_pair;
    });
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.grazing, 0u);
    EXPECT_GT(judged.missed.size(), 0u);
}

TEST(RecordingJudgement, AStaleBoxIsNamedWithItsFrameAndNode) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::aabb)));
    // From frame 3 on the mesh of B is moved, and all its leaves are refitted but one.
    Mesh moved = mesh_b().mesh;
    RecordedMesh mesh{1, "B", 8, {}, {}};
    for (Vec3& vertex : moved.vertices) {
        vertex[2] += 0.3;
        mesh.coordinates.insert(mesh.coordinates.end(), {vertex[0], vertex[1], vertex[2]});
    }
    for (const Triangle& triangle : moved.triangles)
        mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    const auto second = std::find_if(records.begin(), records.end(), [](const Record& record) {
        const auto* frame = std::get_if<RecordedFrame>(&record);
        return frame && frame->frame == 3;
    });
    ASSERT_NE(second, records.end());
    std::vector<Record> told = {mesh};
    constexpr std::uint32_t forgotten = 7;
    for (const Record& record : records)
        if (const auto* node = std::get_if<RecordedNode>(&record); node && node->tree == 1) {
            // Told again it may be, and is stale all the same.
            RecordedRefit refit{1, node->node, node->volume};
            if (node->node != forgotten) refit.volume.values[2] += 0.3;
            told.push_back(refit);
        }
    const auto at = records.insert(second + 1, told.begin(), told.end());
    // The queries after it were made before; they do not count here.
    records.erase(std::find_if(at, records.end(),
                               [](const Record& record) {
                                   return std::holds_alternative<RecordedQuery>(record);
                               }),
                  records.end());
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.trees.size(), 2u);
    EXPECT_TRUE(judged.trees[0].problems.empty());
    ASSERT_EQ(judged.trees[1].problems.size(), 1u);
    const WatchedProblem& problem = judged.trees[1].problems[0];
    EXPECT_EQ(problem.problem.node, forgotten);
    EXPECT_EQ(problem.since, 3);
    EXPECT_TRUE(problem.stale);
    EXPECT_EQ(problem.told_at, 0);
    EXPECT_NEAR(problem.problem.amount, 0.3, 0.15);
}

TEST(RecordingJudgement, WhatOneCannotGoOnWithoutIsASentence) {
    const auto error_of = [](const std::vector<Record>& records) {
        try {
            judge(records);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(error_of({RecordedBody{0, 3, ""}}),
              "test.scbrec: tree 3 is used before it is told (frame 0).");
    EXPECT_EQ(error_of({RecordedQuery{0, 1}}),
              "test.scbrec: body 0 is used before it is told (frame 0).");
    EXPECT_EQ(error_of({RecordedFrame{4}, RecordedFrame{4}}),
              "test.scbrec: frame 4 follows frame 4: frames ascend (frame 4).");
    EXPECT_EQ(error_of({RecordedQueryEnd{}}),
              "test.scbrec: a query ends that did not begin (frame 0).");
    EXPECT_EQ(error_of({RecordedMesh{0, "", 8, {0, 0, 0}, {0, 0, 1}}}).find("test.scbrec: mesh 0"),
              0u);
    EXPECT_EQ(error_of({RecordedTree{0, record_none, "", {}}, RecordedBody{0, 0, ""},
                        RecordedQuery{0, 0}, RecordedFrame{1}}),
              "test.scbrec: frame 1 begins within a query; call scb_record_query_end where a query "
              "ends (frame 0).");
}

TEST(RecordingJudgement, WhatIsOddIsSaid) {
    const RecordingJudgement judged =
        judge({RecordedTree{0, record_none, "", {}}, RecordedRefit{0, 5, {}},
               RecordedEvent{0, 1, 2}, RecordedSetting{"tolerance", "wide"}});
    EXPECT_EQ(judged.odd, (std::vector<std::string>{
                              "node 5, which tree 0 does not have, was refitted, at frame 0",
                              "a test or pair stands outside of queries, at frame 0",
                              "the tolerance \"wide\" is no length, at frame 0"}));
    EXPECT_TRUE(judged.wrong());
}

}  // namespace
}  // namespace scb::scenes
