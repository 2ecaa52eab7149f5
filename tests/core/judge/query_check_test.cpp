#include "core/judge/query_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/judge/pose_fit.h"
#include "scb/triangle_overlap.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

/// A row whose node 2 has a box that is apart from the other row.
std::vector<ToldNode> nodes_with_a_box_elsewhere() {
    std::vector<ToldNode> nodes = nodes_of_row();
    Obb elsewhere = box_of_row(2, 3);
    elsewhere.center[2] = 5;
    nodes[2].volume = elsewhere;
    return nodes;
}

TEST(QueryCheck, AValidQueryHasNoProblems) {
    const Rows rows;
    const QueryJudgement judged = rows.judged();
    EXPECT_EQ(judged.reported, 4u);
    EXPECT_EQ(judged.exact, 4u);
    EXPECT_TRUE(judged.pairs.empty());
    EXPECT_TRUE(judged.wrong_item_tests.empty());
    EXPECT_EQ(judged.count(TestVerdict::right), judged.tests.size());
    EXPECT_EQ(judged.repeated(), 0u);
    EXPECT_EQ(judged.wasted.all(), 0u);
}

TEST(QueryCheck, NamesTheCauseOfAFalsePair) {
    Rows rows;
    rows.query.events.push_back({Kind::pair, 0, 0, 3});
    EXPECT_EQ(rows.problem().cause, PairCause::reported_untested);
    rows.query.events.back() = {Kind::pair, 0, 0, 9};
    EXPECT_EQ(rows.problem().cause, PairCause::unknown_item);
    rows.query.events.back() = {Kind::pair, 0, 2, 2};
    EXPECT_EQ(rows.problem().cause, PairCause::reported_twice);
    EXPECT_EQ(rows.problem().event, rows.query.events.size() - 1);
    rows.query.events.back() = {Kind::items_apart, 0, 0, 3};
    rows.query.events.push_back({Kind::pair, 0, 0, 3});
    EXPECT_EQ(rows.problem().cause, PairCause::reported_in_spite);
    rows.query.events[rows.query.events.size() - 2].kind = Kind::items_meet;
    EXPECT_EQ(rows.problem().cause, PairCause::items_meet);
    EXPECT_EQ(rows.judged().wrong_item_tests.size(), 1u);
}

TEST(QueryCheck, WithoutReportsATriangleInSeveralLeavesMayMeetAnotherTwice) {
    Rows rows;
    for (std::uint32_t i = 0; i < 4; ++i) rows.erase(Kind::pair, i, i);
    rows.query.has_pairs = false;
    rows.query.events.push_back({Kind::items_meet, 0, 1, 1});
    EXPECT_TRUE(rows.judged().pairs.empty());
    EXPECT_EQ(rows.judged().reported, 4u);
}

TEST(QueryCheck, TrianglesOfABodyThatShareAVertexAreNoPair) {
    Rows rows;
    rows.query.sides[1] = rows.query.sides[0];
    rows.query.self = true;
    rows.query.b_to_a = Pose{};
    rows.contacts.clear();
    rows.mesh.triangles[1][0] = rows.mesh.triangles[0][1];
    rows.query.events = {{Kind::pair, 0, 0, 1}};
    EXPECT_EQ(rows.problem().cause, PairCause::neighbours);
    rows.query.events = {{Kind::pair, 0, 1, 1}};
    EXPECT_EQ(rows.problem().cause, PairCause::neighbours) << "a triangle and itself";
    // They cross, too, so any result of their test is accepted.
    rows.mesh.vertices[4] = Vec3(0.1, 0.1, 1);
    rows.mesh.vertices[5] = Vec3(0.1, 0.1, -1);
    rows.query.events = {{Kind::items_apart, 0, 0, 1}};
    EXPECT_TRUE(rows.judged().wrong_item_tests.empty());
    rows.mesh.triangles[1][0] = 3;
    EXPECT_EQ(rows.judged().wrong_item_tests.size(), 1u) << "without a common vertex";
}

TEST(QueryCheck, TrianglesOfALeafNeedNoTestOfTheLeafWithItself) {
    auto nodes = nodes_of_row();
    nodes[3].items = {0, 1};
    nodes[4].items = {};
    Rows rows(nodes);
    rows.query.sides[1] = rows.query.sides[0];
    rows.query.self = true;
    rows.query.b_to_a = Pose{};
    rows.contacts.clear();
    rows.query.events = {{Kind::volumes, 0, 5, 6}, {Kind::items_apart, 0, 0, 1}};
    EXPECT_TRUE(rows.judged().stray_item_tests.empty());
    rows.query.events[1].b = 2;
    EXPECT_EQ(rows.judged().stray_item_tests.size(), 1u) << "of two leaves";
}

TEST(QueryCheck, WhatTouchesWithinTheToleranceIsNotJudged) {
    Rows rows;
    rows.query.tolerance = rows.query.triangle_tolerance = 0.2;
    rows.erase(Kind::pair, 1, 1);
    rows.event(Kind::items_meet, 1, 1).kind = Kind::items_apart;
    rows.event(Kind::volumes, 3, 3).stage = 5;
    const QueryJudgement judged = rows.judged();
    EXPECT_TRUE(judged.pairs.empty());
    EXPECT_EQ(judged.grazing, 1u);
    EXPECT_TRUE(judged.wrong_item_tests.empty());
    EXPECT_EQ(judged.count(TestVerdict::wrong), 0u);
}

TEST(QueryCheck, TestsOfVolumesSmallerThanTheToleranceAreNotJudged) {
    Rows rows;
    rows.query.tolerance = 100;
    const QueryJudgement judged = rows.judged();
    EXPECT_GT(judged.tests.size(), 0u);
    EXPECT_EQ(judged.count(TestVerdict::unjudged), judged.tests.size());
}

// A small triangle and the side of a long one, three thousandths deep in each other: more than any
// rounding, though a bound of the depth of two flat volumes is nearly nothing.
TEST(QueryCheck, AShallowCutIsNotWithinRounding) {
    const Mesh small{{Vec3(0.43, 1.39, 0.84), Vec3(0.40, 1.36, 0.87), Vec3(0.38, 1.39, 0.86)},
                     {{0, 1, 2}}},
        needle{{Vec3(0.3915, 1.384, 0.8580), Vec3(0.3905, 1.381, 0.8575), Vec3(-0.3, 3.3, 0.75)},
               {{0, 1, 2}}};
    const EngineNodes trees[2] = {tree_of({{0, no_index, {}, {0}, Ball{}}}),
                                  tree_of({{0, no_index, {}, {0}, Ball{}}})};
    const TreeShape shapes[2] = {tree_shape(trees[0], 1), tree_shape(trees[1], 1)};
    EngineQuery query;
    query.sides = {EngineSide{&trees[0], &shapes[0], &small},
                   EngineSide{&trees[1], &shapes[1], &needle}};
    query.has_item_tests = query.has_pairs = true;
    query.tolerance = query.triangle_tolerance = 1e-9;
    query.events = {{Kind::items_apart, 0, 0, 0}};
    ASSERT_TRUE(triangles_overlap(corners(small, 0), corners(needle, 0)));
    const QueryJudgement judged = judge_query(query, std::vector<IndexPair>{{0, 0}});
    EXPECT_EQ(judged.grazing, 0u);
    ASSERT_EQ(judged.wrong_item_tests.size(), 1u);
    EXPECT_NEAR(judged.wrong_item_tests[0].margin, 0.0012, 0.0012);
    ASSERT_EQ(judged.pairs.size(), 1u);
    EXPECT_EQ(judged.pairs[0].cause, PairCause::items_apart);
}

TEST(QueryCheck, AChildThatIsForgottenIsSeenWhereNothingIsMissedToo) {
    Rows valid;
    EXPECT_GT(valid.judged().divisions.divided, 2u);
    EXPECT_EQ(valid.judged().divisions.lacking, 0u);
    Rows rows;
    // What is apart anyway.
    rows.erase(Kind::volumes, 1, 2);
    const DivisionCounts two = rows.judged().divisions;
    EXPECT_EQ(two.lacking, 0u) << "both have children in other pairs";
    rows.erase(Kind::volumes, 2, 2);
    rows.erase(Kind::volumes, 2, 1);
    const DivisionCounts found = rows.judged().divisions;
    EXPECT_EQ(found.lacking, 1u);
    EXPECT_EQ(found.first.child, 2u);
    EXPECT_EQ(found.first.side, 0u);
    EXPECT_EQ(found.first.place, 1u);
    EXPECT_TRUE(found.alike);
}

// An engine may test all volumes first, and the triangles of the remaining leaves later.
TEST(QueryCheck, ATestOfTrianglesIsThatOfTheirLeavesWheneverItIsMade) {
    Rows rows;
    std::stable_partition(rows.query.events.begin(), rows.query.events.end(),
                          [](const EngineEvent& event) { return event.kind == Kind::volumes; });
    rows.event(Kind::items_meet, 1, 1).kind = Kind::items_apart;
    rows.erase(Kind::pair, 1, 1);
    const QueryJudgement judged = rows.judged();
    ASSERT_EQ(judged.wrong_item_tests.size(), 1u);
    ASSERT_EQ(judged.pairs.size(), 1u);
    for (const std::uint32_t test : {judged.wrong_item_tests[0].test, judged.pairs[0].test}) {
        ASSERT_LT(test, judged.tests.size());
        EXPECT_EQ(judged.tests[test].nodes, (IndexPair{4, 4}));
    }
    EXPECT_LT(judged.wrong_item_tests[0].test + 1, judged.tests.size()) << "not the last one";
}

TEST(QueryCheck, ATestOfTrianglesOfOtherLeavesIsSeen) {
    Rows rows;
    rows.query.events.push_back({Kind::volumes, 0, 3, 3});
    rows.query.events.push_back({Kind::items_apart, 0, 0, 3});  // 3 is of another leaf
    const QueryJudgement judged = rows.judged();
    EXPECT_TRUE(judged.wrong_item_tests.empty());
    ASSERT_EQ(judged.stray_item_tests.size(), 1u);
    EXPECT_EQ(judged.stray_item_tests[0].event, rows.query.events.size() - 1);
    // Engines whose nodes do not hold what they test, such as CGAL's, are not concerned.
    rows.query.events[rows.query.events.size() - 2] = {Kind::volumes, 0, 0, 0};
    EXPECT_TRUE(rows.judged().stray_item_tests.empty());
}

TEST(QueryCheck, ATestTwiceIsSeen) {
    Rows rows;
    rows.query.events.push_back({Kind::volumes, 0, 2, 2});
    rows.query.events.push_back({Kind::volumes, 0, 77, 2});
    const QueryJudgement judged = rows.judged();
    EXPECT_EQ(judged.repeated(), 1u);
    EXPECT_EQ(judged.tests.back().nodes.a, no_index);
    EXPECT_EQ(judged.count(TestVerdict::unjudged), 1u);
}

TEST(QueryCheck, TheRightPoseFitsAndOthersDoNot) {
    const Rows rows;
    EXPECT_EQ(fit_of_pose(rows.query, rows.query.b_to_a).all_wrong(), 0u);
    Pose other = rows.query.b_to_a;
    other.translation[0] += 1;
    EXPECT_GT(fit_of_pose(rows.query, other).all_wrong(), 4u);
}

// The tolerance of volumes is larger where an engine grows them.
TEST(QueryCheck, TrianglesGrazeWithinTheirOwnTolerance) {
    for (const bool grazes : {true, false}) {
        Rows rows;
        rows.query.tolerance = grazes ? 1e-9 : 0.6;
        rows.query.triangle_tolerance = grazes ? 0.6 : 1e-9;
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.judged().pairs.size(), grazes ? 0u : 1u);
        EXPECT_EQ(rows.judged().grazing, grazes ? 1u : 0u);
        // One that was reported and is half a unit apart.
        rows.query.events.push_back({Kind::pair, 0, 0, 1});
        EXPECT_EQ(rows.judged().pairs.size(), grazes ? 0u : 2u);
        EXPECT_EQ(rows.judged().grazing, grazes ? 2u : 0u);
    }
}

TEST(QueryCheck, WasteIsWhatPairsWithoutAContactBelowThemLedTo) {
    Rows rows;
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 0, 0, 0},    {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 0, 3, 3},    {Kind::items_meet, 0, 0, 0},
                         {Kind::volumes, 0, 2, 2},    {Kind::volumes, 0, 5, 5},
                         {Kind::items_apart, 0, 2, 2}};
    // (2, 2) led to (5, 5), and that to the test of the triangles.
    EXPECT_EQ(rows.judged().wasted.by(PassReason::loose_fit), 2u);
    EXPECT_EQ(rows.judged().wasted.by(PassReason::weak_test), 0u);
    rows.query.events[3].kind = Kind::items_apart;
    EXPECT_EQ(rows.judged().wasted.by(PassReason::loose_fit), 6u)
        << "all but the test of the roots";
}

TEST(QueryCheck, WasteBelowAWeakTestIsOfThatTestAllTheWayDown) {
    Rows rows(nodes_with_a_box_elsewhere());
    rows.contacts = {};
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 2, 2},  // passed although they are apart
                         {Kind::volumes, 0, 5, 5},  // overlap, though they are below these
                         {Kind::items_apart, 0, 2, 2}};
    const QueryJudgement judged = rows.judged();
    EXPECT_EQ(judged.count(TestVerdict::false_positive), 1u);
    EXPECT_EQ(judged.wasted.by(PassReason::loose_fit), 1u);
    EXPECT_EQ(judged.wasted.by(PassReason::weak_test), 2u);
}

TEST(QueryCheck, WasteBelowVolumesThatTouchTheToleranceIsNotJudged) {
    Rows rows(nodes_with_a_box_elsewhere());
    rows.contacts = {};
    rows.query.kind = QueryKind::within;
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 2, 2},
                         {Kind::volumes, 0, 5, 5},
                         {Kind::items_apart, 0, 2, 2}};
    const double gap =
        exact_verdict(rows.trees[0][2].volume, rows.trees[1][2].volume, rows.query.b_to_a, 1e-9)
            .margin;
    ASSERT_GT(gap, 1);
    for (const auto& [limit, reason] :
         {std::pair(gap - 0.1, PassReason::weak_test), std::pair(gap, PassReason::unjudged),
          std::pair(gap + 0.1, PassReason::loose_fit)}) {
        rows.query.limit = limit;
        const QueryJudgement judged = rows.judged();
        EXPECT_EQ(judged.wasted.all(), 3u);
        EXPECT_GE(judged.wasted.by(reason), 2u) << limit;
        if (reason == PassReason::loose_fit) continue;
        EXPECT_EQ(judged.wasted.by(PassReason::loose_fit), 1u) << "below the roots";
    }
}

TEST(QueryCheck, PairsAloneTellWhatATestLedTo) {
    Rows rows;
    rows.query.has_item_tests = false;
    std::erase_if(rows.query.events,
                  [](const EngineEvent& event) { return event.kind == Kind::items_meet; });
    EXPECT_EQ(rows.judged().wasted.by(PassReason::loose_fit), 0u);
    rows.erase(Kind::pair, 3, 3);
    EXPECT_EQ(rows.judged().wasted.by(PassReason::loose_fit), 0u)
        << "(6, 6) led to nothing, (2, 2) to a pair";
    rows.erase(Kind::pair, 2, 2);
    EXPECT_EQ(rows.judged().wasted.by(PassReason::loose_fit), 4u) << "the four pairs below (2, 2)";
}

TEST(QueryCheck, TellsHowFarApartTheVolumesOfATestAre) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 5, 1, 2}};
    EXPECT_NEAR(rows.judged().tests[0].margin, 0.5, 1e-6);
}

TEST(QueryCheck, AWrongTestOfTrianglesWhoseLeavesWereNotTestedHasStrayed) {
    Rows rows;
    rows.event(Kind::items_meet, 1, 1).kind = Kind::items_apart;
    rows.query.events.push_back({Kind::items_meet, 0, 0, 3});
    const QueryJudgement judged = rows.judged();
    ASSERT_EQ(judged.wrong_item_tests.size(), 2u);
    EXPECT_FALSE(judged.wrong_item_tests[0].strayed);
    EXPECT_TRUE(judged.wrong_item_tests[1].strayed);
    EXPECT_NEAR(judged.wrong_item_tests[1].margin, std::hypot(2.5, 0.1), 1e-6);
}

TEST(QueryCheck, OneThatEndedEarlyNeedNotTestAllChildren) {
    Rows rows;
    for (const std::uint32_t b : {1u, 2u}) rows.erase(Kind::volumes, 2, b);
    EXPECT_GT(rows.judged().divisions.lacking, 0u);
    rows.query.complete = false;
    EXPECT_EQ(rows.judged().divisions.divided, 0u);
}

TEST(QueryCheck, OfATreeWithoutNodesNothingIsKnown) {
    Rows rows;
    rows.trees[0] = EngineNodes{};
    rows.shapes[0] = tree_shape(rows.trees[0], rows.mesh.triangles.size());
    rows.query.events = {{Kind::pair, 0, 0, 0}, {Kind::pair, 0, 1, 1}, {Kind::pair, 0, 2, 2}};
    EXPECT_EQ(rows.problem().cause, PairCause::no_tree);
}

TEST(QueryCheck, PairsThatIntersectAreCountedWhereNoResultsWereRecorded) {
    Rows rows;
    std::erase_if(rows.query.events,
                  [](const EngineEvent& event) { return event.kind != Kind::volumes; });
    rows.query.has_item_tests = rows.query.has_pairs = false;
    EXPECT_EQ(rows.judged().without_results, 4u);
    EXPECT_TRUE(rows.judged().pairs.empty());
}

TEST(QueryCheck, APoseThatIsFarOffFitsNoTestThatPassed) {
    Rows rows;
    Pose far = rows.query.b_to_a;
    far.translation[2] += 100;
    const PoseFit fit = fit_of_pose(rows.query, far);
    EXPECT_EQ(fit.wrong, 0u) << "the rejected volumes are apart";
    EXPECT_EQ(fit.wrong_items, 4u);
    EXPECT_EQ(fit.false_positive,
              static_cast<std::uint64_t>(std::count_if(
                  rows.query.events.begin(), rows.query.events.end(), [](const EngineEvent& event) {
                      return event.kind == Kind::volumes && event.stage == 0;
                  })));
    rows.event(Kind::volumes, 3, 3).stage = 5;
    EXPECT_EQ(fit_of_pose(rows.query, rows.query.b_to_a).wrong, 1u);
}

TEST(QueryCheck, EndsWhereItIsInterrupted) {
    Rows rows;
    for (std::uint32_t i = 0; i < 1000; ++i) rows.query.events.push_back({Kind::volumes, 0, 0, 0});
    int asked = 0;
    const QueryJudgement judged =
        judge_query(rows.query, rows.contacts, [&asked] { return ++asked < 3; });
    EXPECT_TRUE(judged.interrupted);
    EXPECT_EQ(asked, 3);
    EXPECT_LT(judged.tests.size(), rows.query.events.size());
    EXPECT_FALSE(judge_query(rows.query, rows.contacts, [] { return true; }).interrupted);
}

}  // namespace
}  // namespace scb
