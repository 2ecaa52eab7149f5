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
    EXPECT_NE(not_judged(judged).find("1 triangles or leaf volumes: at frame 0 the tolerance is 2"),
              std::string::npos)
        << not_judged(judged);
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
