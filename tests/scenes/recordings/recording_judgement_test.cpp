#include "scenes/recordings/recording_judgement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/scene/pose_rows.h"
#include "tests/scenes/recordings/judged_recordings.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

// Both meshes are recorded again before each query.
TEST(RecordingJudgement, UsesTheLatestRecordOfAMesh) {
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
    EXPECT_NE(judged.unusable.first[0].find("tree 1 is of mesh 1, which was not recorded"),
              std::string::npos);
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
        EXPECT_EQ(judged.verdict(), Verdict::valid);
        std::uint64_t pairs = 0, tests = 0;
        for (const QueryTrace& frame : trace.frames) pairs += frame.found.pairs.size();
        for (const FrameJudgement& frame : judged.frames) tests += frame.pairs;
        EXPECT_GT(pairs, 0u);
        EXPECT_EQ(tests, pairs);
        EXPECT_EQ(judged.exact_pairs, pairs);
    }
}

TEST(RecordingJudgement, ASelfQueryHasThePairsOfItsMesh) {
    const Trace trace = record_trace(mesh_a(), mesh_a(), asking_self(VolumeKind::obb), {0});
    const auto kind = static_cast<std::size_t>(VolumeKind::obb);
    const TracedBody body{&mesh_a().mesh, &mesh_a().hierarchies[kind]};
    TraceRecording recording(trace.header, {body, body});
    recording.add(trace.frames[0], {Pose{}, Pose{}});
    const RecordingJudgement judged = judge(recording.finish());
    EXPECT_EQ(judged.verdict(), Verdict::valid);
    EXPECT_GT(judged.exact_pairs, 0u);
    EXPECT_EQ(judged.exact_pairs, trace.frames[0].found.pairs.size());
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
        for (const QueryTrace& frame : trace.frames)
            sum += attribute(mesh_a().hierarchies[kind], mesh_b().hierarchies[kind], trace.header,
                             frame, frame.found.pairs)
                       .counts;
        const RecordingJudgement judged = judge(recording_of(trace));
        EXPECT_EQ(judged.wasted.all(), sum.wasted().volume_tests + sum.wasted().triangle_tests);
        EXPECT_GT(judged.wasted.by(PassReason::loose_fit), 0u);
        EXPECT_EQ(judged.stages[0].false_positives, sum.passed(PassReason::weak_test));
    }
}

TEST(RecordingJudgement, NamesTheWrongRejectionsOfThePrintedTest) {
    // Line 8 of Figure 8 as it is printed rejects some volumes that overlap.
    const Trace trace = trace_of(VolumeKind::scb, OverlapTest::printed);
    const RecordingJudgement judged = judge(recording_of(trace));
    std::uint64_t wrong = 0, wrongly_rejected = 0;
    for (const FrameJudgement& frame : judged.frames) wrong += frame.wrong;
    for (const QueryTrace& frame : trace.frames)
        wrongly_rejected +=
            attribute(mesh_a().hierarchies[0], mesh_b().hierarchies[0], trace.header, frame, {})
                .wrongly_rejected.size();
    EXPECT_EQ(wrong, wrongly_rejected);
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
            // The volume is recorded again without a change, so it is stale all the same.
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
    EXPECT_EQ(problem.recorded_at, 0);
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
              "test.scbrec: tree 3 is used before it is recorded (frame 0).");
    EXPECT_EQ(error_of({RecordedQuery{0, 1}}),
              "test.scbrec: body 0 is used before it is recorded (frame 0).");
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

// The verdict on slab cut balls proves a depth above the tolerance, and no more.
TEST(RecordingJudgement, TheDepthOfWrongTestsIsTheDepthThatExplainProves) {
    const RecordedVolume disc = {RecordedKind::scb, {0, 0, 0, 1, 0, 0, 1, 0.5, -0.5}};
    std::vector<Record> records = body_of_one_node(0, disc);
    append(records, body_of_one_node(1, disc));
    for (const double depth : {0.125, 0.25}) append(records, rejection_at(2 - depth));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.stages.size(), 1u);
    EXPECT_NEAR(judged.stages[0].least_depth, 0.125, 1e-6);
    EXPECT_NEAR(judged.stages[0].most_depth, 0.25, 1e-6);
    ASSERT_EQ(judged.test_problems.size(), 1u);
    EXPECT_NE(judged.test_problems[0].cases.at(0).words.find(", 0.125 deep in each other"),
              std::string::npos)
        << judged.test_problems[0].cases[0].words;
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
    // The second child is not recorded yet.
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

TEST(RecordingJudgement, DivisionsThatLackAChildBelongToTheVerdict) {
    const std::string what = "divisions of nodes";
    EXPECT_EQ(part_of(judged_divisions(0, 4), what), nullptr);
    const RecordingJudgement judged = judged_divisions(2, 2);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    const NotJudged* part = part_of(judged, what);
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->count, 2u);
    EXPECT_EQ(part->of, 4u);
    EXPECT_NE(
        part->why.find("was not tested, and the recording does not show whether this is intended"),
        std::string::npos);
    EXPECT_NE(part->why.find("node 2 of A was not tested"), std::string::npos);
    EXPECT_NE(part->why.find("in all of them child 2 of the node of A"), std::string::npos);
    const RecordingJudgement unlike = judged_divisions(2, 2, true);
    ASSERT_NE(part_of(unlike, what), nullptr);
    EXPECT_EQ(part_of(unlike, what)->why.find("in all of them"), std::string::npos);
    // Always forgetting one is no better.
    ASSERT_NE(part_of(judged_divisions(4, 0), what), nullptr);
    EXPECT_EQ(part_of(judged_divisions(4, 0), what)->count, 4u);
}

/// Four triangles of A that lie in a row along x. An upright triangle of B crosses each. Each
/// triangle has a leaf, and each side one root.
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

}  // namespace
}  // namespace scb::scenes
