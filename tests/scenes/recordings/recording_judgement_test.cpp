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
#include "tests/scenes/recordings/small_records.h"
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
        {bytes, "test.scbrec"}, [](int) { return true; }, [](bool) { return true; });
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

TEST(RecordingJudgement, ATreeOfAMeshThatWasNotRecordedIsNotJudged) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    std::erase_if(records, [](const Record& record) {
        const auto* mesh = std::get_if<RecordedMesh>(&record);
        return mesh != nullptr && mesh->mesh == 1;
    });
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    ASSERT_EQ(judged.unusable.count, 1u);
    EXPECT_NE(judged.unusable.first[0].find("tree 1 is of mesh 1, which was not told"),
              std::string::npos);
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
        EXPECT_EQ(judged.trees.size(), 2u);
        EXPECT_EQ(judged.trees[0].nodes, 2 * mesh_a().mesh.triangles.size() - 1);
        EXPECT_EQ(judged.verdict(), Verdict::sound);
        std::uint64_t pairs = 0, tests = 0;
        for (const TraceFrame& frame : trace.frames) pairs += frame.found.pairs.size();
        for (const FrameJudgement& frame : judged.frames) tests += frame.pairs;
        EXPECT_GT(pairs, 0u);
        EXPECT_EQ(tests, pairs);
        EXPECT_EQ(judged.exact_pairs, pairs);
    }
}

// They end above the triangles on purpose.
TEST(RecordingJudgement, FindsNothingMissedByOwnQueriesToALevel) {
    TraceHeader header = asking(VolumeKind::obb, OverlapTest::corrected);
    header.options.stop_level = 4;
    const RecordingJudgement judged =
        judge(recording_of(record_trace(mesh_a(), mesh_b(), header, {0, 3})));
    EXPECT_FALSE(judged.wrong());
    EXPECT_EQ(judged.ended_early, 2u);
    for (const FrameJudgement& frame : judged.frames) {
        EXPECT_GT(frame.volume_tests, 0u);
        EXPECT_EQ(frame.pairs, 0u);
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

/// B's ball at this distance from A's, which a test rejects at stage 1.
std::vector<Record> rejection_at(double distance) {
    std::vector<Record> records = {pose_at(1, distance)};
    append(records, query_with({{1, 0, 0}}));
    return records;
}

TEST(RecordingJudgement, AStageHasTheLeastAndTheGreatestDepthOfItsWrongTests) {
    std::vector<Record> records = two_balls();
    for (const double depth : {0.25, 0.5, -1.0, 0.125, 0.375})
        append(records, rejection_at(2 - depth));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.stages.size(), 1u);
    EXPECT_EQ(judged.stages[0].tests, 5u);
    EXPECT_EQ(judged.stages[0].wrong, 4u);
    EXPECT_NEAR(judged.stages[0].least_depth, 0.125, 1e-9);
    EXPECT_NEAR(judged.stages[0].most_depth, 0.5, 1e-9);
}

TEST(RecordingJudgement, JudgesTheFramesThatAreWantedUntilItIsStopped) {
    std::vector<Record> records = two_balls();
    for (const std::uint32_t frame : {0u, 1u, 2u, 3u}) {
        append(records, {RecordedFrame{frame}});
        append(records, rejection_at(3));
        append(records, rejection_at(4));
    }
    RecordingWriter writer;
    for (const Record& record : records) writer.add(record);
    const std::string bytes = writer.finish();
    const RecordingJudgement odd = judge_recording(
        {bytes, "x"}, [](int frame) { return frame % 2 == 1; }, [](bool) { return true; });
    ASSERT_EQ(odd.frames.size(), 2u);
    EXPECT_EQ(odd.frames[0].frame, 1);
    EXPECT_EQ(odd.frames[1].frame, 3);
    EXPECT_EQ(odd.frames[0].queries, 2u);
    EXPECT_EQ(odd.stages.at(0).tests, 4u);
    const RecordingJudgement stopped = judge_recording(
        {bytes, "x"}, [](int) { return true; }, [](bool) { return false; });
    EXPECT_EQ(stopped.frames.size(), 1u);
    EXPECT_EQ(stopped.frames_left, stopped.summary.frames.size());
    EXPECT_EQ(stopped.verdict(), Verdict::partly_judged) << "the rest was not judged";
}

TEST(RecordingJudgement, CountsAllCasesOfAProblemAndKeepsTheFirstHundred) {
    std::vector<Record> records = two_balls();
    append(records, query_with({{0, 0, 8}}));
    append(records, query_with(std::vector<RecordedEvent>(150, {3, 0, 0})));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.test_problems.size(), 2u);
    // The most frequent one stands first.
    EXPECT_EQ(judged.test_problems[0].count, 150u);
    EXPECT_EQ(judged.test_problems[0].cases.size(), ProblemGroup::most_cases);
    EXPECT_EQ(judged.test_problems[0].cases[0].test, 0u);
    EXPECT_EQ(judged.test_problems[1].count, 1u);
    EXPECT_EQ(judged.test_problems[1].cases[0].nodes, (IndexPair{0, 8}));
}

// Fronts and traversals without a stack repeat tests.
TEST(RecordingJudgement, RepeatedTestsAreACostAndNotWrong) {
    std::vector<Record> records = two_balls();
    append(records, query_with(std::vector<RecordedEvent>(3, {0, 0, 0})));
    const RecordingJudgement judged = judge(records);
    EXPECT_FALSE(judged.wrong());
    ASSERT_EQ(judged.costs.size(), 1u);
    EXPECT_EQ(judged.costs[0].kind, CostFinding::Kind::repeated);
    EXPECT_EQ(judged.costs[0].count, 2u);
    EXPECT_EQ(judged.costs[0].of, 3u);
}

TEST(RecordingJudgement, ATreeIsAsDeepAsItsDeepestNode) {
    const auto node = [](std::uint32_t number, std::uint32_t parent,
                         const std::vector<std::uint32_t>& children) {
        return RecordedNode{0, number, parent, 0, "", children, {}, ball_volume(1)};
    };
    const RecordingJudgement judged =
        judge({RecordedTree{0, record_none, "", {}}, node(0, record_none, {1, 2}), node(1, 0, {3}),
               node(2, 0, {}), node(3, 1, {})});
    ASSERT_EQ(judged.trees.size(), 1u);
    EXPECT_EQ(judged.trees[0].depth, 2u);
    EXPECT_EQ(judged.trees[0].nodes, 4u);
    EXPECT_FALSE(judged.wrong());
}

TEST(RecordingJudgement, ATreeThatTheFileBreaksOffInIsNotBroken) {
    // Its second child was not told yet.
    const RecordedVolume volume = ball_volume(1);
    std::vector<Record> records = {RecordedTree{0, record_none, "", {}},
                                   RecordedNode{0, 0, record_none, 0, "", {1, 2}, {}, volume},
                                   RecordedNode{0, 1, 0, 0, "", {}, {0}, volume}};
    const RecordingJudgement broken_off = judge(records);
    ASSERT_EQ(broken_off.trees.size(), 1u);
    EXPECT_TRUE(broken_off.trees[0].unfinished);
    EXPECT_FALSE(broken_off.wrong());
    EXPECT_NE(broken_off.damage, "");
    records.emplace_back(RecordedEnd{});
    const RecordingJudgement whole = judge(records);
    EXPECT_FALSE(whole.trees[0].unfinished);
    EXPECT_TRUE(whole.wrong());
}

TEST(RecordingJudgement, OfAQueryThatEndsEarlyNothingIsMissed) {
    for (const bool complete : {true, false}) {
        std::vector<Record> records = {RecordedSetting{"results", "pairs"}};
        append(records, two_balls());
        append(records, query_with({{0, 0, 0}}, complete));
        const RecordingJudgement judged = judge(records);
        EXPECT_EQ(judged.ended_early, complete ? 0u : 1u);
        EXPECT_EQ(judged.missed.size(), complete ? 1u : 0u);
        EXPECT_EQ(judged.frames.at(0).missed, complete ? 1u : 0u);
    }
}

TEST(RecordingJudgement, AQueryWithoutAPoseIsNotJudged) {
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

TEST(RecordingJudgement, AScaledBodyIsJudgedWithItsScale) {
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

/// A root and two children, and queries of it and of one node: of so many only the first child was
/// tested, of the others both were.
RecordingJudgement judged_divisions(std::uint32_t lacking, std::uint32_t whole,
                                    bool alternate = false) {
    std::vector<Record> records = {
        RecordedTree{0, record_none, "", {}},
        RecordedNode{0, 0, record_none, 0, "", {1, 2}, {}, ball_volume(1)},
        RecordedNode{0, 1, 0, 0, "", {}, {0}, ball_volume(1)},
        RecordedNode{0, 2, 0, 0, "", {}, {1}, ball_volume(1)}, RecordedBody{0, 0, "A"}};
    append(records, body_of_one_node(1, ball_volume(1)));
    for (std::uint32_t i = 0; i < whole; ++i)
        append(records, query_with({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}));
    for (std::uint32_t i = 0; i < lacking; ++i)
        append(records, query_with({{0, 0, 0}, {0, alternate && i % 2 == 1 ? 2u : 1u, 0}}));
    return judge(records);
}

/// What was not judged of this kind.
const NotJudged* part_of(const RecordingJudgement& judged, const std::string& what) {
    const auto found = std::find_if(judged.not_judged.begin(), judged.not_judged.end(),
                                    [&what](const NotJudged& part) { return part.what == what; });
    return found == judged.not_judged.end() ? nullptr : &*found;
}

TEST(RecordingJudgement, DivisionsThatLackAChildBelongToTheVerdict) {
    const std::string what = "divisions of nodes";
    EXPECT_EQ(part_of(judged_divisions(0, 4), what), nullptr);
    const RecordingJudgement judged = judged_divisions(2, 2);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    const NotJudged* part = part_of(judged, what);
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->count, 2u);
    EXPECT_EQ(part->of, 4u);
    EXPECT_NE(part->why.find("node 2 of A was not tested"), std::string::npos);
    EXPECT_NE(part->why.find("in all of them child 2 of the node of A"), std::string::npos);
    const RecordingJudgement unlike = judged_divisions(2, 2, true);
    ASSERT_NE(part_of(unlike, what), nullptr);
    EXPECT_EQ(part_of(unlike, what)->why.find("in all of them"), std::string::npos);
    // Always forgetting one is no better.
    ASSERT_NE(part_of(judged_divisions(4, 0), what), nullptr);
    EXPECT_EQ(part_of(judged_divisions(4, 0), what)->count, 4u);
}

TEST(RecordingJudgement, QueriesOfABodyWithoutKnownItemsAreCounted) {
    std::vector<Record> records = {RecordedMesh{0, "", 8, {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}}};
    append(records, two_balls());
    append(records, {RecordedTree{2, 0, "", {}}, RecordedBody{2, 2, "C"}});
    for (const auto& [a, b] : {std::pair(0u, 2u), {2u, 0u}, {0u, 1u}, {2u, 2u}, {0u, 0u}})
        append(records, {RecordedQuery{a, b}, RecordedQueryEnd{}});
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.unknown_items, 2u);
}

/// Four triangles that lie in a row along x, of A, each of which is crossed by one that stands, of
/// B; a leaf for each below one root.
std::vector<Record> crossing_rows() {
    std::vector<Record> records;
    for (std::uint32_t side = 0; side < 2; ++side) {
        RecordedMesh mesh{side, "", 8, {}, {}};
        std::vector<Record> leaves;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const double x = i;
            const std::vector<double> corners =
                side == 0 ? std::vector<double>{x, 0, 0, x + 0.5, 0, 0, x, 0.5, 0}
                          : std::vector<double>{x + 0.1, 0.1,     -0.5, x + 0.3, 0.1,
                                                -0.5,    x + 0.1, 0.1,  0.5};
            mesh.coordinates.insert(mesh.coordinates.end(), corners.begin(), corners.end());
            mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
            leaves.emplace_back(RecordedNode{
                side, i + 1, 0, 0, "", {}, {i}, {RecordedKind::aabb, {x, 0, -1, x + 0.5, 0.5, 1}}});
        }
        records.emplace_back(mesh);
        records.emplace_back(RecordedTree{side, side, "", {}});
        records.emplace_back(RecordedNode{side,
                                          0,
                                          record_none,
                                          0,
                                          "",
                                          {1, 2, 3, 4},
                                          {},
                                          {RecordedKind::aabb, {0, 0, -1, 4, 1, 1}}});
        append(records, leaves);
        records.emplace_back(RecordedBody{side, side, side == 0 ? "A" : "B"});
    }
    return records;
}

TEST(RecordingJudgement, CountsMissedAndFalsePairsOfAFrame) {
    std::vector<Record> records = crossing_rows();
    append(records, query_with({{0, 0, 0},
                                {0, 1, 1},
                                {items_meet, 0, 0},
                                {a_pair, 0, 0},
                                {0, 2, 2},
                                {items_apart, 1, 1},
                                {0, 3, 3},
                                {a_pair, 2, 3}}));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.frames.size(), 1u);
    const FrameJudgement& frame = judged.frames[0];
    EXPECT_EQ(frame.missed, 3u);
    EXPECT_EQ(frame.false_pairs, 1u);
    EXPECT_EQ(frame.pairs, 2u);
    EXPECT_EQ(frame.wrong, 1u);
    EXPECT_EQ(judged.exact_pairs, 4u);
    std::uint64_t missed = 0, reported_falsely = 0;
    for (const ProblemGroup& group : judged.missed) missed += group.count;
    for (const ProblemGroup& group : judged.false_pairs) reported_falsely += group.count;
    EXPECT_EQ(missed, 3u);
    EXPECT_EQ(reported_falsely, 1u);
    // Its test of volumes is the one before it.
    EXPECT_EQ(judged.false_pairs[0].cases[0].items, (IndexPair{2, 3}));
    EXPECT_EQ(judged.false_pairs[0].cases[0].test, 3u);
}

TEST(RecordingJudgement, ABrokenTreeIsWrongThoughNoQueryErrs) {
    std::vector<Record> records = crossing_rows();
    EXPECT_FALSE(judge(records).wrong());
    for (Record& record : records)
        if (auto* node = std::get_if<RecordedNode>(&record);
            node && node->tree == 1 && node->node == 2)
            node->volume.values[3] = 1.2;
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.wrong());
    EXPECT_TRUE(judged.trees.at(0).problems.empty());
    ASSERT_EQ(judged.trees.at(1).problems.size(), 1u);
    EXPECT_EQ(judged.trees[1].problems[0].problem.node, 2u);
}

TEST(RecordingJudgement, NamesTheBodyWhoseNodeDoesNotContainItsTriangle) {
    for (std::uint32_t side = 0; side < 2; ++side) {
        std::vector<Record> records = crossing_rows();
        // Node 2 is above its triangle, number 1, so that its test is right to reject it.
        for (Record& record : records)
            if (auto* node = std::get_if<RecordedNode>(&record);
                node && node->tree == side && node->node == 2)
                node->volume.values = {1, 0, 5, 1.5, 0.5, 6};
        append(records, query_with({{0, 0, 0},
                                    {0, 1, 1},
                                    {items_meet, 0, 0},
                                    {3, 2, 2},
                                    {0, 3, 3},
                                    {items_meet, 2, 2},
                                    {0, 4, 4},
                                    {items_meet, 3, 3}}));
        const RecordingJudgement judged = judge(records);
        ASSERT_EQ(judged.missed.size(), 1u);
        ASSERT_EQ(judged.missed[0].cases.size(), 1u);
        const ProblemCase& missed = judged.missed[0].cases[0];
        EXPECT_EQ(missed.items, (IndexPair{1, 1}));
        EXPECT_EQ(missed.nodes, (IndexPair{2, 2}));
        EXPECT_NE(missed.words.find(side == 0 ? "node 2 of A does not contain triangle 1"
                                              : "node 2 of B does not contain triangle 1"),
                  std::string::npos)
            << missed.words;
    }
}

/// A tree of three objects, one unit apart along x, and a probe at the middle one; the extents of
/// the objects are recorded where `extents` says so.
std::vector<Record> broadphase(bool extents) {
    const auto box = [](double x, double size) {
        return RecordedVolume{RecordedKind::aabb, {x, 0, 0, x + size, 0.5, 0.5}};
    };
    std::vector<Record> records = {
        RecordedSetting{"results", "pairs"}, RecordedTree{0, record_none, "manager", {}},
        RecordedNode{0, 0, record_none, 0, "", {1, 2, 3}, {}, box(0, 2.5)}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        records.emplace_back(RecordedNode{0, i + 1, 0, 0, "", {}, {i}, box(i, 0.5)});
        if (extents) records.emplace_back(RecordedObject{0, i, box(i, 0.5)});
    }
    append(records, {RecordedBody{0, 0, "manager"}, RecordedTree{1, record_none, "probe", {}},
                     RecordedNode{1, 0, record_none, 0, "", {}, {0}, box(1.25, 0.5)}});
    if (extents) records.emplace_back(RecordedObject{1, 0, box(1.25, 0.5)});
    append(records, {RecordedBody{1, 1, "probe"}, RecordedFrame{0}});
    append(records, query_with({{0, 0, 0}, {0, 2, 0}, {a_pair, 1, 0}}));
    return records;
}

TEST(RecordingJudgement, LeavesOfObjectsAreJudgedWhereTheirExtentsAreRecorded) {
    const std::string what = "leaf volumes of tree 0 \"manager\"";
    const RecordingJudgement without = judge(broadphase(false));
    EXPECT_EQ(without.verdict(), Verdict::partly_judged);
    ASSERT_NE(part_of(without, what), nullptr);
    EXPECT_EQ(part_of(without, what)->count, 3u);
    EXPECT_EQ(part_of(without, what)->of, 3u);
    std::vector<Record> whole = broadphase(true);
    whole.emplace_back(RecordedEnd{});
    EXPECT_EQ(judge(whole).verdict(), Verdict::sound);

    // Object 2 moves to the probe, and its leaf does not.
    std::vector<Record> records = broadphase(true);
    append(records, {RecordedFrame{1},
                     RecordedObject{0, 2, {RecordedKind::aabb, {1, 0, 0, 1.5, 0.5, 0.5}}}});
    append(records, query_with({{0, 0, 0}, {0, 2, 0}, {a_pair, 1, 0}}));
    const RecordingJudgement stale = judge(records);
    EXPECT_TRUE(stale.wrong());
    ASSERT_EQ(stale.trees.at(0).problems.size(), 1u);
    const WatchedProblem& problem = stale.trees[0].problems[0];
    EXPECT_EQ(problem.words, "node 3 does not contain object 2, by 1");
    EXPECT_TRUE(problem.stale);
    EXPECT_EQ(problem.since, 1);
    ASSERT_EQ(stale.missed.size(), 1u);
    EXPECT_EQ(stale.missed[0].cases[0].items, (IndexPair{2, 0}));
    EXPECT_NE(stale.missed[0].cases[0].words.find("node 3 of A does not contain object 2"),
              std::string::npos)
        << stale.missed[0].cases[0].words;
}

TEST(RecordingJudgement, AStageKeepsItsNameWhereItemsAreObjects) {
    std::vector<Record> records = broadphase(true);
    records.insert(records.begin(), RecordedStage{1, "triangle-box"});
    append(records, query_with({{0, 0, 0}, {1, 2, 0}}));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.missed.size(), 1u);
    EXPECT_NE(judged.missed[0].cases[0].words.find("stage \"triangle-box\""), std::string::npos);
    EXPECT_NE(judged.missed[0].cases[0].words.find("objects 1 of A"), std::string::npos);
}

TEST(RecordingJudgement, ExactTestsThatPassVolumesThatAreApartAreWrong) {
    for (const bool exact : {false, true}) {
        std::vector<Record> records = two_balls();
        if (exact) records.insert(records.begin(), RecordedSetting{"tests", "exact"});
        append(records, {pose_at(1, 5)});
        append(records, query_with({{0, 0, 0}}));
        const RecordingJudgement judged = judge(records);
        EXPECT_EQ(judged.wrong(), exact);
        EXPECT_NEAR(judged.stages.at(0).most_apart, 3, 1e-9);
        EXPECT_NE(judged.stages[0].farthest.find("nodes 0 of A and 0 of B"), std::string::npos);
        if (exact) {
            EXPECT_NE(judged.test_problems.at(0).cases.at(0).words.find("3 apart"),
                      std::string::npos);
        }
    }
}

TEST(RecordingJudgement, WhatIsOddIsSaid) {
    const RecordingJudgement judged =
        judge({RecordedTree{0, record_none, "", {}}, RecordedRefit{0, 5, {}},
               RecordedEvent{0, 1, 2}, RecordedSetting{"tolerance", "wide"}});
    EXPECT_EQ(
        judged.odd.first,
        (std::vector<std::string>{"node 5, which tree 0 does not have, was refitted, at frame 0"}));
    EXPECT_EQ(judged.unusable.first,
              (std::vector<std::string>{"a test or pair stands outside of queries, at frame 0",
                                        "the tolerance \"wide\" is no length, at frame 0"}));
    EXPECT_TRUE(judged.wrong());
}

/// The reasons why parts are not judged.
std::string not_judged(const RecordingJudgement& judged) {
    std::string all;
    for (const NotJudged& part : judged.not_judged)
        all += std::to_string(part.count) + " " + part.what + ": " + part.why + "\n";
    return all;
}

/// A triangle that reaches from 0 to 1, of which a leaf has this box.
std::vector<Record> triangle_in_box(std::vector<double> box, std::vector<double> root = {}) {
    std::vector<Record> records = {
        RecordedMesh{0, "m", 4, {0, 0, 0, 1, 0, 0, 0, 1, 0.1f}, {0, 1, 2}},
        RecordedTree{0, 0, "t", {}}};
    if (!root.empty())
        records.emplace_back(
            RecordedNode{0, 1, record_none, 0, "", {0}, {}, {RecordedKind::aabb, root}});
    records.emplace_back(RecordedNode{0,
                                      0,
                                      root.empty() ? record_none : 1,
                                      0,
                                      "",
                                      {},
                                      {0},
                                      {RecordedKind::aabb, std::move(box)}});
    append(records, {RecordedFrame{0}, RecordedEnd{}});
    return records;
}

TEST(RecordingJudgement, AHugeRootDoesNotHideALeaf) {
    const std::vector<double> huge = {-1e13, -1e13, -1e13, 1e13, 1e13, 1e13};
    EXPECT_EQ(judge(triangle_in_box({0, 0, 0, 1, 1, 1}, huge)).verdict(), Verdict::sound);
    const RecordingJudgement beside = judge(triangle_in_box({170, 0, 0, 171, 1, 1}, huge));
    ASSERT_EQ(beside.trees[0].problems.size(), 1u);
    EXPECT_EQ(beside.trees[0].problems[0].problem.node, 0u);
}

// A recording of trees alone has a tolerance, too.
TEST(RecordingJudgement, TreesWhoseToleranceHidesTheirTrianglesAreNotJudged) {
    std::vector<Record> records = triangle_in_box({2e6, 0, 0, 2e6 + 1, 1, 1});
    std::get<RecordedMesh>(records[0]).coordinates = {2e6, 0, 0, 2e6 + 1, 0, 0, 2e6, 1, 0.125};
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_NE(not_judged(judged).find("1 triangles or leaf volumes: at frame 0 the tolerance is 2"),
              std::string::npos)
        << not_judged(judged);
}

TEST(RecordingJudgement, NamesTheSettingAsTheCauseOfAWideTolerance) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedSetting{"tolerance", "4"}});
    append(records, query_with({{0, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_NE(not_judged(judged).find("the setting `tolerance` of the recording says so"),
              std::string::npos)
        << not_judged(judged);
}

TEST(RecordingJudgement, ATestOfVolumesWithoutAnExactTestIsNotJudged) {
    std::vector<Record> records = two_balls();
    append(records,
           {RecordedRefit{
               0, 0, {RecordedKind::scb2, {0, 0, 0, 1, 1, 0, 0, 0.5, -0.5, 0, 1, 0, 0.5, -0.5}}}});
    append(records, query_with({{1, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_EQ(judged.unjudged, 1u);
}

TEST(RecordingJudgement, ATreeThatWasRecordedWithoutNodesHasNoUnknownOnes) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedTree{1, record_none, "", {}}});
    append(records, query_with({{1, 0, 5}}));
    EXPECT_EQ(judge(records).verdict(), Verdict::partly_judged);
}

// Each pose that moves the two apart explains that one test.
TEST(RecordingJudgement, APoseIsNotNamedForTestsOfOneOutcome) {
    std::vector<Record> records = two_balls();
    append(records, {pose_at(0, 0), pose_at(1, 1.5)});
    append(records, query_with({{1, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.test_problems.size(), 1u);
    EXPECT_TRUE(judged.poses.empty());
}

TEST(RecordingJudgement, WithoutPairsATestOfTwoTrianglesMayBeRepeated) {
    std::vector<Record> records = records_in(recording_of(trace_of(VolumeKind::obb)));
    std::erase_if(records, [](const Record& record) {
        const auto* event = std::get_if<RecordedEvent>(&record);
        const auto* setting = std::get_if<RecordedSetting>(&record);
        return (event && event->tag == a_pair) || (setting && setting->key == "results");
    });
    const auto meets = [](const Record& record) {
        const auto* event = std::get_if<RecordedEvent>(&record);
        return event && event->tag == items_meet;
    };
    const auto first = std::find_if(records.begin(), records.end(), meets);
    ASSERT_NE(first, records.end());
    records.insert(first, Record(*first));
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.false_pairs.empty());
    EXPECT_FALSE(judged.wrong());
}

/// A cloth of two triangles with a common edge, and one above them. `gap`: how far the upper one is
/// from a vertex of the lower ones at the second frame.
std::vector<Record> folding_cloth(double gap) {
    const auto mesh = [](double x, double z) {
        return RecordedMesh{
            0,
            "cloth",
            8,
            {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, x, 0, z, x + 1, 0, z + 1, x, 1, z + 1},
            {0, 1, 2, 1, 3, 2, 4, 5, 6}};
    };
    std::vector<Record> records = {mesh(0, 5),
                                   RecordedTree{0, 0, "t", {}},
                                   RecordedNode{0,
                                                0,
                                                record_none,
                                                0,
                                                "",
                                                {},
                                                {0, 1, 2},
                                                {RecordedKind::aabb, {-10, -10, -10, 10, 10, 10}}},
                                   RecordedBody{0, 0, "cloth"},
                                   RecordedSetting{"results", "pairs"},
                                   RecordedFrame{0}};
    append(records, {RecordedQuery{0, 0}, RecordedQueryEnd{}, RecordedFrame{1}, mesh(0, gap),
                     RecordedQuery{0, 0}, RecordedEvent{a_pair, 0, 2}, RecordedQueryEnd{}});
    return records;
}

// A vertex of the upper layer comes to lie on one of the lower layer, which is another vertex.
TEST(RecordingJudgement, VerticesThatMeetLaterAreNotJoined) {
    const RecordingJudgement touching = judge(folding_cloth(0));
    EXPECT_FALSE(touching.wrong()) << not_judged(touching);
    const RecordingJudgement apart = judge(folding_cloth(0.5));
    ASSERT_EQ(apart.false_pairs.size(), 1u);
    EXPECT_EQ(apart.false_pairs[0].what, "reported without a test of the two triangles");
}

TEST(RecordingJudgement, TheTrianglesOfALeafAreTestedWithEachOther) {
    std::vector<Record> records = folding_cloth(-0.25);
    const auto end = records.end() - 2;
    records.insert(end, RecordedEvent{items_meet, 0, 2});
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.test_problems.empty());
    EXPECT_FALSE(judged.wrong());
}

TEST(RecordingJudgement, AnObjectThatItsTreeDoesNotHaveIsUnknown) {
    std::vector<Record> records = two_balls();
    append(records, query_with({{0, 0, 0}, {a_pair, 77, 99}}));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.false_pairs.size(), 1u);
    EXPECT_EQ(judged.false_pairs[0].what, "one of the two does not exist");
}

TEST(RecordingJudgement, AnObjectsOwnTestMayFindThatItIsApart) {
    const auto judged_with = [](std::uint8_t tag, double x) {
        std::vector<Record> records = two_balls();
        append(records, {RecordedObject{0, 0, ball_volume(1)}, RecordedObject{1, 0, ball_volume(1)},
                         RecordedSetting{"results", "pairs"}, pose_at(0, 0), pose_at(1, x)});
        append(records,
               query_with({{static_cast<std::uint8_t>(x > 2 ? 1 : 0), 0, 0}, {tag, 0, 0}}));
        records.emplace_back(RecordedEnd{});
        return judge(records);
    };
    EXPECT_EQ(judged_with(items_apart, 1.5).verdict(), Verdict::sound)
        << "extents are larger than their objects";
    const RecordingJudgement meet = judged_with(items_meet, 5);
    ASSERT_EQ(meet.test_problems.size(), 1u) << "objects whose extents are apart do not meet";
}

TEST(RecordingJudgement, AQueryThatTheFileBreaksOffInIsNotJudgedWhole) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedQuery{0, 1}, RecordedEvent{0, 0, 0}});
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_NE(not_judged(judged).find("the file breaks off in the last one"), std::string::npos);
}

}  // namespace
}  // namespace scb::scenes
