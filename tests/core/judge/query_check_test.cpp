#include "core/judge/query_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scb/triangle_overlap.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

TEST(QueryCheck, ASoundQueryHasNoProblems) {
    const Rows rows;
    const QueryJudgement judged = rows.judged();
    EXPECT_EQ(judged.reported, 4u);
    EXPECT_EQ(judged.exact, 4u);
    EXPECT_TRUE(judged.pairs.empty());
    EXPECT_TRUE(judged.wrong_item_tests.empty());
    EXPECT_EQ(judged.count(TestVerdict::right), judged.tests.size());
    EXPECT_EQ(judged.repeated(), 0u);
    EXPECT_EQ(judged.wasted_loose + judged.wasted_weak, 0u);
}

TEST(QueryCheck, NamesTheCauseOfAMissedPair) {
    {
        Rows rows;  // rejected though they overlap
        rows.event(Kind::volumes, 3, 3).stage = 5;
        rows.erase(Kind::items_meet, 0, 0);
        rows.erase(Kind::pair, 0, 0);
        const PairProblem problem = rows.problem();
        EXPECT_EQ(problem.cause, PairCause::rejected);
        EXPECT_EQ(problem.items, (IndexPair{0, 0}));
        EXPECT_EQ(problem.nodes, (IndexPair{3, 3}));
        EXPECT_EQ(rows.judged().count(TestVerdict::wrong), 1u);
    }
    {
        auto nodes = nodes_of_row();  // a box that is elsewhere
        nodes[2].volume = Obb{Vec3(3.25, 5, 0), Mat3::Identity(), Vec3(1, 0.25, 0.1)};
        Rows rows(nodes);
        for (const std::uint32_t i : {2u, 3u}) rows.erase(Kind::pair, i, i);
        const QueryJudgement judged = rows.judged();
        ASSERT_EQ(judged.pairs.size(), 2u);
        EXPECT_EQ(judged.pairs[0].cause, PairCause::not_contained);
        EXPECT_EQ(judged.pairs[0].nodes.a, 2u);
        EXPECT_EQ(judged.pairs[0].side, 0u);
        EXPECT_GT(judged.pairs[0].amount, 4);
        EXPECT_EQ(judged.count(TestVerdict::wrong), 0u) << "the volumes are apart";
    }
    {
        Rows rows;  // below (2, 2) nothing was tested
        std::erase_if(rows.query.events, [](const EngineEvent& e) {
            return e.kind == Kind::volumes ? e.a >= 5 && e.b >= 5 : e.a >= 2 && e.b >= 2;
        });
        const QueryJudgement judged = rows.judged();
        ASSERT_EQ(judged.pairs.size(), 2u);
        EXPECT_EQ(judged.pairs[0].cause, PairCause::never_visited);
        EXPECT_EQ(judged.pairs[0].nodes, (IndexPair{2, 2}));
    }
    {
        Rows rows;
        rows.erase(Kind::items_meet, 1, 1);
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.problem().cause, PairCause::items_not_tested);
    }
    {
        Rows rows;
        rows.event(Kind::items_meet, 1, 1).a = 4;
        const QueryJudgement judged = rows.judged();
        ASSERT_EQ(judged.wrong_item_tests.size(), 1u);
        EXPECT_TRUE(judged.wrong_item_tests[0].unknown);
    }
    {
        Rows rows;
        rows.event(Kind::items_meet, 1, 1).kind = Kind::items_apart;
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.problem().cause, PairCause::items_apart);
        EXPECT_EQ(rows.judged().wrong_item_tests.size(), 1u);
    }
    {
        Rows rows;
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.problem().cause, PairCause::not_reported);
    }
    {
        auto nodes = nodes_of_row();
        nodes[4].items = {};
        Rows rows(nodes);
        rows.erase(Kind::pair, 1, 1);
        const PairProblem problem = rows.problem();
        EXPECT_EQ(problem.cause, PairCause::in_no_leaf);
        EXPECT_EQ(problem.side, 0u);
    }
    {
        Rows rows;
        rows.query.events.clear();
        rows.query.events.push_back({Kind::pair, 0, 0, 0});
        const QueryJudgement judged = rows.judged();
        ASSERT_EQ(judged.pairs.size(), 3u);
        EXPECT_EQ(judged.pairs[0].cause, PairCause::no_tests);
        // Tests of other nodes say that the query makes tests.
        rows.query.events.push_back({Kind::volumes, 0, 6, 6});
        EXPECT_EQ(rows.judged().pairs[0].cause, PairCause::never_tested);
        rows.query.complete = false;
        EXPECT_TRUE(rows.judged().pairs.empty()) << "it ended early on purpose";
    }
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

// A small triangle and the side of a long one, three thousandths deep in each other: more than any
// rounding, though a bound of the depth of two flat volumes is nearly nothing.
TEST(QueryCheck, AShallowCutIsNotWithinRounding) {
    const Mesh small{{Vec3(0.43, 1.39, 0.84), Vec3(0.40, 1.36, 0.87), Vec3(0.38, 1.39, 0.86)},
                     {{0, 1, 2}}},
        needle{{Vec3(0.3915, 1.384, 0.8580), Vec3(0.3905, 1.381, 0.8575), Vec3(-0.3, 3.3, 0.75)},
               {{0, 1, 2}}};
    const NodeTree trees[2] = {tree_of({{0, no_index, {}, {0}, Ball{}}}),
                               tree_of({{0, no_index, {}, {0}, Ball{}}})};
    const TreeShape shapes[2] = {tree_shape(trees[0], 1), tree_shape(trees[1], 1)};
    EngineQuery query;
    query.sides = {EngineSide{&trees[0], &shapes[0], &small},
                   EngineSide{&trees[1], &shapes[1], &needle}};
    query.tells_items = query.tells_pairs = true;
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
    Rows sound;
    EXPECT_GT(sound.judged().divisions.divided, 2u);
    EXPECT_EQ(sound.judged().divisions.lacking, 0u);
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

// An engine may test all volumes first, and the triangles of what is left later.
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

// An engine may go on below a pair that it has rejected, and come back to one above it.
TEST(QueryCheck, APairIsMissedAtTheFirstRejectionInTime) {
    Rows rows;
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 5, 3, 3}, {Kind::volumes, 5, 1, 1}};
    EXPECT_EQ(rows.problem().nodes, (IndexPair{3, 3}));
    rows.query.events = {{Kind::volumes, 5, 1, 1}, {Kind::volumes, 5, 3, 3}};
    EXPECT_EQ(rows.problem().nodes, (IndexPair{1, 1}));
    EXPECT_EQ(rows.problem().event, 0u);
}

TEST(QueryCheck, APairThatWasNotRejectedIsLostBelowTheDeepestOverlap) {
    Rows rows;
    rows.contacts = {{0, 2}};
    rows.query.events = {{Kind::volumes, 0, 1, 0}, {Kind::volumes, 0, 0, 5}};
    EXPECT_EQ(rows.problem().cause, PairCause::never_visited);
    EXPECT_EQ(rows.problem().nodes, (IndexPair{0, 5}));
    EXPECT_EQ(rows.problem().next, (IndexPair{1, no_index})) << "B's node is the leaf";
    rows.query.events = {{Kind::volumes, 0, 3, 0}, {Kind::volumes, 0, 0, 2}};
    EXPECT_EQ(rows.problem().cause, PairCause::never_visited);
    EXPECT_EQ(rows.problem().nodes, (IndexPair{3, 0}));
    EXPECT_EQ(rows.problem().next, (IndexPair{no_index, 2}));
}

TEST(QueryCheck, EachTriangleIsLookedForInTheNodeOfItsOwnSide) {
    Rows rows;
    rows.contacts = {{0, 2}};
    rows.query.events = {{Kind::volumes, 5, 1, 5}};
    EXPECT_EQ(rows.problem().cause, PairCause::rejected_unproven) << "their volumes do not overlap";
    EXPECT_EQ(rows.problem().nodes, (IndexPair{1, 5}));
}

TEST(QueryCheck, ATriangleOutsideByLessThanTheToleranceIsNoCause) {
    auto nodes = nodes_of_row();
    nodes[3].volume = box_of_row(0, -0.125);  // triangle 0 is outside by an eighth
    Rows rows(nodes);
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 5, 3, 3}};
    rows.query.tolerance = 0.25;
    EXPECT_EQ(rows.problem().cause, PairCause::rejected_unproven);
    rows.query.tolerance = 0.0625;
    EXPECT_EQ(rows.problem().cause, PairCause::not_contained);
    EXPECT_NEAR(rows.problem().amount, 0.125, 1e-12);
}

TEST(QueryCheck, OfTwoVolumesThatDoNotContainTheirTrianglesTheWorseOneIsTold) {
    const auto moved = [](double by) {
        auto nodes = nodes_of_row();
        Obb box = box_of_row(0, 0);
        box.center[1] += by;
        nodes[3].volume = box;
        return nodes;
    };
    for (const auto& [a, b] : {std::pair(1.0, 4.0), {4.0, 1.0}, {0.0, 2.0}}) {
        Rows rows(moved(a), moved(b));
        rows.contacts = {{0, 0}};
        rows.query.events = {{Kind::volumes, 5, 3, 3}};
        const PairProblem problem = rows.problem();
        EXPECT_EQ(problem.cause, PairCause::not_contained);
        EXPECT_EQ(problem.side, a > b ? 0u : 1u);
        EXPECT_NEAR(problem.amount, std::max(a, b), 1e-12);
    }
}

TEST(QueryCheck, NamesTheSideOfATriangleThatIsInNoLeaf) {
    auto nodes = nodes_of_row();
    nodes[4].items = {};
    for (const std::uint32_t side : {0u, 1u}) {
        Rows rows(side == 0 ? nodes : nodes_of_row(), side == 1 ? nodes : nodes_of_row());
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.problem().cause, PairCause::in_no_leaf);
        EXPECT_EQ(rows.problem().side, side);
    }
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
    EXPECT_EQ(rows.judged().wasted_loose, 2u);
    EXPECT_EQ(rows.judged().wasted_weak, 0u);
    rows.query.events[3].kind = Kind::items_apart;
    EXPECT_EQ(rows.judged().wasted_loose, 6u) << "all but the test of the roots";
}

TEST(QueryCheck, WasteBelowAWeakTestIsOfThatTestAllTheWayDown) {
    auto nodes = nodes_of_row();
    Obb elsewhere = box_of_row(2, 3);
    elsewhere.center[2] = 5;
    nodes[2].volume = elsewhere;
    Rows rows(nodes);
    rows.contacts = {};
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 2, 2},  // passed although they are apart
                         {Kind::volumes, 0, 5, 5},  // overlap, though they are below these
                         {Kind::items_apart, 0, 2, 2}};
    const QueryJudgement judged = rows.judged();
    EXPECT_EQ(judged.count(TestVerdict::false_positive), 1u);
    EXPECT_EQ(judged.wasted_loose, 1u);
    EXPECT_EQ(judged.wasted_weak, 2u);
}

TEST(QueryCheck, PairsAloneTellWhatATestLedTo) {
    Rows rows;
    rows.query.tells_items = false;
    std::erase_if(rows.query.events,
                  [](const EngineEvent& event) { return event.kind == Kind::items_meet; });
    EXPECT_EQ(rows.judged().wasted_loose, 0u);
    rows.erase(Kind::pair, 3, 3);
    EXPECT_EQ(rows.judged().wasted_loose, 0u) << "(6, 6) led to nothing, (2, 2) to a pair";
    rows.erase(Kind::pair, 2, 2);
    EXPECT_EQ(rows.judged().wasted_loose, 4u) << "the four pairs below (2, 2)";
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

// A recording of pairs alone: the node that does not contain its triangle is the cause.
TEST(QueryCheck, AMissedPairWithoutTestsNamesTheNodeThatDoesNotContainIt) {
    auto nodes = nodes_of_row();
    nodes[1].volume = box_of_row(0, 0.75);
    Rows rows(nodes);
    rows.query.events.clear();
    for (const std::uint32_t i : {0u, 2u, 3u}) rows.query.events.push_back({Kind::pair, 0, i, i});
    const PairProblem problem = rows.problem();
    EXPECT_EQ(problem.cause, PairCause::below_outside);
    EXPECT_EQ(problem.nodes.a, 1u);
    EXPECT_EQ(problem.nodes.b, no_index);
    EXPECT_NEAR(problem.amount, 0.25, 1e-12);
}

// Node 4 has the part of triangle 0 that node 3 does not have; neither contains all of it.
TEST(QueryCheck, APartOfASplitTriangleIsNoCauseOfAMissedPair) {
    auto nodes = nodes_of_row();
    nodes[3].volume = box_between(Vec3(0, 0, 0), Vec3(0.25, 0.5, 0));
    nodes[4].volume = box_between(Vec3(0.25, 0, 0), Vec3(1.5, 0.5, 0));
    nodes[4].items = {1, 0};
    Rows rows(nodes);
    rows.query.events.clear();
    for (const std::uint32_t i : {1u, 2u, 3u}) rows.query.events.push_back({Kind::pair, 0, i, i});
    EXPECT_EQ(rows.problem().cause, PairCause::no_tests);
}

// A body against itself: the first of two nodes may have the second triangle.
TEST(QueryCheck, ARejectionTheOtherWayRoundIsFound) {
    Rows rows;
    rows.query.self = true;
    rows.query.sides[1] = rows.query.sides[0];
    rows.query.b_to_a = Pose{};
    // Triangle 2 stands in triangle 0.
    for (std::uint32_t i = 6; i < 9; ++i)
        rows.mesh.vertices[i] = Vec3(0.1 + 0.1 * (i % 3), 0.1, i == 7 ? 1 : -1);
    rows.query.events = {{Kind::volumes, 0, 0, 0}, {Kind::volumes, 5, 2, 1}};
    const std::vector<IndexPair> contacts = {{0, 2}};
    const QueryJudgement judged = judge_query(rows.query, contacts);
    ASSERT_EQ(judged.pairs.size(), 1u);
    EXPECT_EQ(judged.pairs[0].test, 1u);
    EXPECT_EQ(judged.pairs[0].nodes, (IndexPair{2, 1}));
}

TEST(QueryCheck, OfATreeWithoutNodesNothingIsKnown) {
    Rows rows;
    rows.trees[0] = NodeTree{};
    rows.shapes[0] = tree_shape(rows.trees[0], rows.mesh.triangles.size());
    rows.query.events = {{Kind::pair, 0, 0, 0}, {Kind::pair, 0, 1, 1}, {Kind::pair, 0, 2, 2}};
    EXPECT_EQ(rows.problem().cause, PairCause::no_tree);
}

TEST(QueryCheck, APairThatIsRejectedAtANodeWithoutAVolumeNamesIt) {
    Rows rows;
    rows.trees[0].set_volume(1, {}, 0, "not all of its numbers are numbers of use");
    rows.erase(Kind::pair, 1, 1);
    std::erase_if(rows.query.events, [](const EngineEvent& event) {
        return event.kind != Kind::pair && event.kind != Kind::volumes && event.a == 1;
    });
    rows.event(Kind::volumes, 1, 1).stage = 5;
    const PairProblem problem = rows.problem();
    EXPECT_EQ(problem.cause, PairCause::bad_volume);
    EXPECT_EQ(problem.side, 0u);
    EXPECT_EQ(problem.nodes, (IndexPair{1, 1}));
}

TEST(QueryCheck, PairsThatIntersectAreCountedWhereNoResultsWereRecorded) {
    Rows rows;
    std::erase_if(rows.query.events,
                  [](const EngineEvent& event) { return event.kind != Kind::volumes; });
    rows.query.tells_items = rows.query.tells_pairs = false;
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
