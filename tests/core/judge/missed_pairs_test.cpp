#include "core/judge/missed_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scb/triangle_overlap.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

TEST(MissedPairs, ARejectedPairThatOverlapsIsWrong) {
    Rows rows;
    rows.event(Kind::volumes, 3, 3).stage = 5;
    rows.erase(Kind::items_meet, 0, 0);
    rows.erase(Kind::pair, 0, 0);
    const PairProblem problem = rows.problem();
    EXPECT_EQ(problem.cause, PairCause::rejected);
    EXPECT_EQ(problem.items, (IndexPair{0, 0}));
    EXPECT_EQ(problem.nodes, (IndexPair{3, 3}));
    EXPECT_EQ(rows.judged().count(TestVerdict::wrong), 1u);
}

TEST(MissedPairs, AVolumeThatMissesItsItemsIsNamed) {
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

TEST(MissedPairs, NodesBelowAPairThatPassedAreNeverVisited) {
    Rows rows;  // below (2, 2) nothing was tested
    std::erase_if(rows.query.events, [](const EngineEvent& e) {
        return e.kind == Kind::volumes ? e.a >= 5 && e.b >= 5 : e.a >= 2 && e.b >= 2;
    });
    const QueryJudgement judged = rows.judged();
    ASSERT_EQ(judged.pairs.size(), 2u);
    EXPECT_EQ(judged.pairs[0].cause, PairCause::never_visited);
    EXPECT_EQ(judged.pairs[0].nodes, (IndexPair{2, 2}));
}

TEST(MissedPairs, ItemsOfLeavesAreNotTested) {
    Rows rows;
    rows.erase(Kind::items_meet, 1, 1);
    rows.erase(Kind::pair, 1, 1);
    EXPECT_EQ(rows.problem().cause, PairCause::items_not_tested);
}

TEST(MissedPairs, AnItemOfNoMeshIsUnknown) {
    Rows rows;
    rows.event(Kind::items_meet, 1, 1).a = 4;
    const QueryJudgement judged = rows.judged();
    ASSERT_EQ(judged.wrong_item_tests.size(), 1u);
    EXPECT_TRUE(judged.wrong_item_tests[0].unknown);
}

TEST(MissedPairs, ItemsThatMeetAreCalledApart) {
    Rows rows;
    rows.event(Kind::items_meet, 1, 1).kind = Kind::items_apart;
    rows.erase(Kind::pair, 1, 1);
    EXPECT_EQ(rows.problem().cause, PairCause::items_apart);
    EXPECT_EQ(rows.judged().wrong_item_tests.size(), 1u);
}

TEST(MissedPairs, APairThatWasFoundIsNotReported) {
    Rows rows;
    rows.erase(Kind::pair, 1, 1);
    EXPECT_EQ(rows.problem().cause, PairCause::not_reported);
}

TEST(MissedPairs, AnItemIsInNoLeaf) {
    auto nodes = nodes_of_row();
    nodes[4].items = {};
    Rows rows(nodes);
    rows.erase(Kind::pair, 1, 1);
    const PairProblem problem = rows.problem();
    EXPECT_EQ(problem.cause, PairCause::in_no_leaf);
    EXPECT_EQ(problem.side, 0u);
}

TEST(MissedPairs, AQueryWithoutTestsHasACauseOfItsOwn) {
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

// An engine may go on below a pair that it has rejected, and come back to one above it.
TEST(MissedPairs, APairIsMissedAtTheFirstRejectionInTime) {
    Rows rows;
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 5, 3, 3}, {Kind::volumes, 5, 1, 1}};
    EXPECT_EQ(rows.problem().nodes, (IndexPair{3, 3}));
    rows.query.events = {{Kind::volumes, 5, 1, 1}, {Kind::volumes, 5, 3, 3}};
    EXPECT_EQ(rows.problem().nodes, (IndexPair{1, 1}));
    EXPECT_EQ(rows.problem().event, 0u);
}

TEST(MissedPairs, APairThatWasNotRejectedIsLostBelowTheDeepestOverlap) {
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

TEST(MissedPairs, EachTriangleIsLookedForInTheNodeOfItsOwnSide) {
    Rows rows;
    rows.contacts = {{0, 2}};
    rows.query.events = {{Kind::volumes, 5, 1, 5}};
    EXPECT_EQ(rows.problem().cause, PairCause::rejected_unproven) << "their volumes do not overlap";
    EXPECT_EQ(rows.problem().nodes, (IndexPair{1, 5}));
}

TEST(MissedPairs, ATriangleOutsideByLessThanTheToleranceIsNoCause) {
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

TEST(MissedPairs, OfTwoVolumesThatDoNotContainTheirTrianglesTheWorseOneIsTold) {
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

TEST(MissedPairs, NamesTheSideOfATriangleThatIsInNoLeaf) {
    auto nodes = nodes_of_row();
    nodes[4].items = {};
    for (const std::uint32_t side : {0u, 1u}) {
        Rows rows(side == 0 ? nodes : nodes_of_row(), side == 1 ? nodes : nodes_of_row());
        rows.erase(Kind::pair, 1, 1);
        EXPECT_EQ(rows.problem().cause, PairCause::in_no_leaf);
        EXPECT_EQ(rows.problem().side, side);
    }
}

// A recording of pairs alone: the node that does not contain its triangle is the cause.
TEST(MissedPairs, AMissedPairWithoutTestsNamesTheNodeThatDoesNotContainIt) {
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
TEST(MissedPairs, APartOfASplitTriangleIsNoCauseOfAMissedPair) {
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
TEST(MissedPairs, ARejectionTheOtherWayRoundIsFound) {
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

TEST(MissedPairs, APairThatIsRejectedAtANodeWithoutAVolumeNamesIt) {
    Rows rows;
    rows.trees[0].set_volume(1, {}, 0, "one of its numbers is not finite or too large");
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

}  // namespace
}  // namespace scb
