#include <gtest/gtest.h>

#include <algorithm>

#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/scene/pose_rows.h"
#include "tests/scenes/recordings/judged_recordings.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

TEST(JudgedObjects, QueriesOfABodyWithoutKnownItemsAreCounted) {
    std::vector<Record> records = {RecordedMesh{0, "", 8, {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}}};
    append(records, two_balls());
    append(records, {RecordedTree{2, 0, "", {}}, RecordedBody{2, 2, "C"}});
    for (const auto& [a, b] : {std::pair(0u, 2u), {2u, 0u}, {0u, 1u}, {2u, 2u}, {0u, 0u}})
        append(records, {RecordedQuery{a, b}, RecordedQueryEnd{}});
    const RecordingJudgement judged = judge(records);
    EXPECT_EQ(judged.unknown_items, 2u);
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

TEST(JudgedObjects, LeavesOfObjectsAreJudgedWhereTheirExtentsAreRecorded) {
    const std::string what = "leaf volumes of tree 0 \"manager\"";
    const RecordingJudgement without = judge(broadphase(false));
    EXPECT_EQ(without.verdict(), Verdict::partly_judged);
    ASSERT_NE(part_of(without, what), nullptr);
    EXPECT_EQ(part_of(without, what)->count, 3u);
    EXPECT_EQ(part_of(without, what)->of, 3u);
    std::vector<Record> whole = broadphase(true);
    whole.emplace_back(RecordedEnd{});
    EXPECT_EQ(judge(whole).verdict(), Verdict::valid);

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

TEST(JudgedObjects, AStageKeepsItsNameWhereItemsAreObjects) {
    std::vector<Record> records = broadphase(true);
    records.insert(records.begin(), RecordedStage{1, "triangle-box"});
    append(records, query_with({{0, 0, 0}, {1, 2, 0}}));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.missed.size(), 1u);
    EXPECT_NE(judged.missed[0].cases[0].words.find("stage \"triangle-box\""), std::string::npos);
    EXPECT_NE(judged.missed[0].cases[0].words.find("objects 1 of A"), std::string::npos);
}

TEST(JudgedObjects, AnObjectThatItsTreeDoesNotHaveIsUnknown) {
    std::vector<Record> records = two_balls();
    append(records, query_with({{0, 0, 0}, {a_pair, 77, 99}}));
    const RecordingJudgement judged = judge(records);
    ASSERT_EQ(judged.false_pairs.size(), 1u);
    EXPECT_EQ(judged.false_pairs[0].what, "one of the two does not exist");
}

TEST(JudgedObjects, AnObjectsOwnTestMayFindThatItIsApart) {
    const auto judged_with = [](std::uint8_t tag, double x) {
        std::vector<Record> records = two_balls();
        append(records, {RecordedObject{0, 0, ball_volume(1)}, RecordedObject{1, 0, ball_volume(1)},
                         RecordedSetting{"results", "pairs"}, pose_at(0, 0), pose_at(1, x)});
        append(records,
               query_with({{static_cast<std::uint8_t>(x > 2 ? 1 : 0), 0, 0}, {tag, 0, 0}}));
        records.emplace_back(RecordedEnd{});
        return judge(records);
    };
    EXPECT_EQ(judged_with(items_apart, 1.5).verdict(), Verdict::valid)
        << "extents are larger than their objects";
    const RecordingJudgement meet = judged_with(items_meet, 5);
    ASSERT_EQ(meet.test_problems.size(), 1u) << "objects whose extents are apart do not meet";
}

}  // namespace
}  // namespace scb::scenes
