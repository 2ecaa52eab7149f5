#include "core/judge/query_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scb/triangle_overlap.h"
#include "tests/core/judge/judged_tree.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

/// Two rows of triangles, one of which stands across the other: each meets that of its number.
struct Rows {
    Mesh mesh = row_of_triangles();
    NodeTree trees[2];
    TreeShape shapes[2];
    EngineQuery query;
    std::vector<IndexPair> contacts;

    explicit Rows(std::vector<ToldNode> nodes_of_a = nodes_of_row()) {
        trees[0] = tree_of(nodes_of_a);
        trees[1] = tree_of(nodes_of_row());
        for (std::size_t side = 0; side < 2; ++side) {
            shapes[side] = tree_shape(trees[side], mesh.triangles.size());
            query.sides[side] = {&trees[side], &shapes[side], &mesh};
        }
        query.b_to_a.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        query.b_to_a.translation = Vec3(0, 0.1, -0.1);
        query.tells_items = query.tells_pairs = true;
        query.tolerance = 1e-9;
        for (std::uint32_t i = 0; i < 4; ++i) contacts.push_back({i, i});
        visit(0, 0);
        for (const IndexPair pair : contacts)
            query.events.push_back({Kind::pair, 0, pair.a, pair.b});
    }
    Rows(const Rows&) = delete;

    /// As a sound engine does it.
    void visit(std::uint32_t a, std::uint32_t b) {
        const TreeNode &node_a = trees[0][a], &node_b = trees[1][b];
        const bool apart =
            exact_verdict(node_a.volume, node_b.volume, query.b_to_a, 1e-9).contact ==
            Contact::disjoint;
        query.events.push_back({Kind::volumes, static_cast<std::uint8_t>(apart ? 5 : 0),
                                node_a.number, node_b.number});
        if (apart) return;
        for (const std::uint32_t item_a : trees[0].items(a))
            for (const std::uint32_t item_b : trees[1].items(b))
                query.events.push_back(
                    {triangles_overlap(corners(mesh, item_a),
                                       transform_corners(query.b_to_a, corners(mesh, item_b)))
                         ? Kind::items_meet
                         : Kind::items_apart,
                     0, item_a, item_b});
        for (const std::uint32_t child_a : trees[0].children(a))
            for (const std::uint32_t child_b : trees[1].children(b))
                visit(trees[0].index_of(child_a), trees[1].index_of(child_b));
    }

    EngineEvent& event(Kind kind, std::uint32_t a, std::uint32_t b) {
        const auto found = std::find_if(
            query.events.begin(), query.events.end(),
            [&](const EngineEvent& e) { return e.kind == kind && e.a == a && e.b == b; });
        EXPECT_NE(found, query.events.end());
        return *found;
    }
    void erase(Kind kind, std::uint32_t a, std::uint32_t b) {
        query.events.erase(query.events.begin() + (&event(kind, a, b) - query.events.data()));
    }
    QueryJudgement judged() const { return judge_query(query, contacts); }
    /// The one problem that there is.
    PairProblem problem() const {
        const QueryJudgement found = judged();
        EXPECT_EQ(found.pairs.size(), 1u);
        return found.pairs.empty() ? PairProblem{} : found.pairs[0];
    }
};

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
        EXPECT_EQ(judged.pairs[0].cause, PairCause::never_tested);
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
    const DivisionCounts none = rows.judged().divisions;
    EXPECT_EQ(none.lacking, 0u) << "both have children in other pairs";
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

}  // namespace
}  // namespace scb
