#include <gtest/gtest.h>

#include <algorithm>

#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/scene/pose_rows.h"
#include "tests/scenes/recordings/judged_recordings.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

/// A triangle that reaches from 0 to 1, in a leaf with this box.
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

TEST(JudgementLimits, AHugeRootDoesNotHideALeaf) {
    const std::vector<double> huge = {-1e13, -1e13, -1e13, 1e13, 1e13, 1e13};
    EXPECT_EQ(judge(triangle_in_box({0, 0, 0, 1, 1, 1}, huge)).verdict(), Verdict::valid);
    const RecordingJudgement beside = judge(triangle_in_box({170, 0, 0, 171, 1, 1}, huge));
    ASSERT_EQ(beside.trees[0].problems.size(), 1u);
    EXPECT_EQ(beside.trees[0].problems[0].problem.node, 0u);
}

// A recording of trees alone has a tolerance, too.
TEST(JudgementLimits, TreesWhoseToleranceHidesTheirTrianglesAreNotJudged) {
    std::vector<Record> records = triangle_in_box({2e6, 0, 0, 2e6 + 1, 1, 1});
    std::get<RecordedMesh>(records[0]).coordinates = {2e6, 0, 0, 2e6 + 1, 0, 0, 2e6, 1, 0.125};
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    for (const char* part : {"1 triangles or leaf volumes: at frame 0 the tolerance is 2",
                             ", and 1 of 1 triangles of "})
        EXPECT_NE(not_judged(judged).find(part), std::string::npos) << not_judged(judged);
}

TEST(JudgementLimits, NamesTheSettingAsTheCauseOfAWideTolerance) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedSetting{"tolerance", "4"}});
    append(records, query_with({{0, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_NE(not_judged(judged).find("the setting `tolerance` of the recording says so"),
              std::string::npos)
        << not_judged(judged);
}

TEST(JudgementLimits, ATestOfVolumesWithoutAnExactTestIsNotJudged) {
    std::vector<Record> records = two_balls();
    append(records,
           {RecordedRefit{
               0, 0, {RecordedKind::scb2, {0, 0, 0, 1, 1, 0, 0, 0.5, -0.5, 0, 1, 0, 0.5, -0.5}}}});
    append(records, query_with({{1, 0, 0}}));
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_EQ(judged.unjudged, 1u);
}

/// Eight triangles in a row, in leaves 5 to 12. Nodes 1 to 4 have two leaves each, and reach, as
/// the root 0 does, up to a large triangle above the row, which no leaf does.
std::vector<Record> row_in_high_boxes() {
    const auto box = [](double from, double to, double top) -> RecordedVolume {
        return {RecordedKind::aabb, {from, 0, 0, to, 1, top}};
    };
    RecordedMesh row{0, "row", 8, {}, {}};
    for (std::uint32_t i = 0; i < 8; ++i) {
        const double x = 10 * i;
        for (const double number : {x, 0.0, 0.0, x + 1, 0.0, 0.0, x, 1.0, 0.0})
            row.coordinates.push_back(number);
        for (const std::uint32_t corner : {0u, 1u, 2u}) row.indices.push_back(3 * i + corner);
    }
    std::vector<Record> records = {
        row, RecordedMesh{1, "above", 8, {0, 0, 5, 80, 0, 5, 0, 1, 5}, {0, 1, 2}},
        RecordedTree{0, 0, "row", {}},
        RecordedNode{0, 0, record_none, 0, "", {1, 2, 3, 4}, {}, box(0, 71, 6)}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        const double x = 20 * k;
        records.emplace_back(
            RecordedNode{0, 1 + k, 0, 0, "", {5 + 2 * k, 6 + 2 * k}, {}, box(x, x + 11, 6)});
        for (const std::uint32_t i : {2 * k, 2 * k + 1})
            records.emplace_back(
                RecordedNode{0, 5 + i, 1 + k, 0, "", {}, {i}, box(10 * i, 10 * i + 1, 0)});
    }
    append(
        records,
        {RecordedTree{1, 1, "above", {}},
         RecordedNode{1, 0, record_none, 0, "", {}, {0}, {RecordedKind::aabb, {0, 0, 5, 80, 1, 5}}},
         RecordedBody{0, 0, "A"}, RecordedBody{1, 1, "B"}});
    std::vector<RecordedEvent> tests = {{0, 0, 0}};
    for (std::uint32_t k = 0; k < 4; ++k)
        for (const RecordedEvent& test :
             {RecordedEvent{0, 1 + k, 0}, {1, 5 + 2 * k, 0}, {1, 6 + 2 * k, 0}})
            tests.push_back(test);
    append(records, query_with(tests));
    return records;
}

TEST(JudgementLimits, LooseBoxesAreACostIfTheyAreAQuarter) {
    const RecordingJudgement judged = judge(row_in_high_boxes());
    EXPECT_FALSE(judged.wrong());
    ASSERT_EQ(judged.costs.size(), 1u);
    const CostFinding& cost = judged.costs[0];
    EXPECT_EQ(cost.kind, CostFinding::Kind::loose);
    EXPECT_EQ(cost.count, 4u) << "the root is long";
    EXPECT_EQ(cost.of, 13u);
    EXPECT_EQ(cost.tests, 13u);
    EXPECT_EQ(cost.tests_if_tight, 1u);
}

TEST(JudgementLimits, ATreeThatWasRecordedWithoutNodesHasNoUnknownOnes) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedTree{1, record_none, "", {}}});
    append(records, query_with({{1, 0, 5}}));
    EXPECT_EQ(judge(records).verdict(), Verdict::partly_judged);
}

TEST(JudgementLimits, WithoutPairsATestOfTwoTrianglesMayBeRepeated) {
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
TEST(JudgementLimits, VerticesThatMeetLaterAreNotJoined) {
    const RecordingJudgement touching = judge(folding_cloth(0));
    EXPECT_FALSE(touching.wrong()) << not_judged(touching);
    const RecordingJudgement apart = judge(folding_cloth(0.5));
    ASSERT_EQ(apart.false_pairs.size(), 1u);
    EXPECT_EQ(apart.false_pairs[0].what, "reported without a test of the two triangles");
}

TEST(JudgementLimits, TheTrianglesOfALeafAreTestedWithEachOther) {
    std::vector<Record> records = folding_cloth(-0.25);
    const auto end = records.end() - 2;
    records.insert(end, RecordedEvent{items_meet, 0, 2});
    const RecordingJudgement judged = judge(records);
    EXPECT_TRUE(judged.test_problems.empty());
    EXPECT_FALSE(judged.wrong());
}

TEST(JudgementLimits, AQueryThatTheFileBreaksOffInIsNotJudgedWhole) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedQuery{0, 1}, RecordedEvent{0, 0, 0}});
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.verdict(), Verdict::partly_judged);
    EXPECT_NE(not_judged(judged).find("the file breaks off in the last one"), std::string::npos);
}

}  // namespace
}  // namespace scb::scenes
