#include "core/judge/division_check.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

/// The divisions of a query whose tests are these and all pass.
DivisionCounts divisions(const std::vector<IndexPair>& tests) {
    Rows rows;
    rows.query.events.clear();
    for (const IndexPair nodes : tests)
        rows.query.events.push_back({Kind::volumes, 0, nodes.a, nodes.b});
    return check_divisions(rows.query, rows.judged().tests);
}

TEST(DivisionCheck, TheNodeOfOneSideIsDividedIntoAllItsChildren) {
    EXPECT_EQ(divisions({{0, 0}}).divided, 0u);
    const DivisionCounts valid = divisions({{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, 2}});
    EXPECT_EQ(valid.divided, 2u);
    EXPECT_EQ(valid.lacking, 0u);
    const DivisionCounts of_a = divisions({{0, 0}, {2, 0}});
    EXPECT_EQ(of_a.lacking, 1u);
    EXPECT_EQ(of_a.first.test, 0u);
    EXPECT_EQ(of_a.first.side, 0u);
    EXPECT_EQ(of_a.first.child, 1u);
    EXPECT_EQ(of_a.first.place, 0u);
    const DivisionCounts of_b = divisions({{0, 0}, {0, 1}, {0, 2}, {0, 5}});
    EXPECT_EQ(of_b.divided, 2u);
    EXPECT_EQ(of_b.lacking, 1u);
    EXPECT_EQ(of_b.first.test, 2u);
    EXPECT_EQ(of_b.first.side, 1u);
    EXPECT_EQ(of_b.first.child, 6u);
    EXPECT_EQ(of_b.first.place, 1u);
}

TEST(DivisionCheck, OfBothNodesAtOnceEachChildIsInSomePair) {
    EXPECT_EQ(divisions({{0, 0}, {1, 1}, {2, 2}}).lacking, 0u) << "the other pairs may be apart";
    const DivisionCounts found = divisions({{0, 0}, {1, 1}, {2, 1}});
    EXPECT_EQ(found.divided, 1u);
    EXPECT_EQ(found.lacking, 1u);
    EXPECT_EQ(found.first.side, 1u);
    EXPECT_EQ(found.first.child, 2u);
    // The children of A with the whole node of B, and the other way round: of neither all need be.
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {0, 1}}).divided, 0u);
}

TEST(DivisionCheck, AChildThatIsApartNeedNotBeTested) {
    // Child 2 of B is apart from node 1 of A, child 1 is not.
    EXPECT_EQ(divisions({{1, 0}, {1, 1}}).lacking, 0u);
    EXPECT_EQ(divisions({{1, 0}, {1, 2}}).lacking, 1u);
}

TEST(DivisionCheck, ATestThatIsMadeAgainIsNoChild) {
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {2, 0}, {0, 0}, {1, 0}}).lacking, 0u);
}

TEST(DivisionCheck, LacksAreAlikeInTheSamePlaceOfTheSameSide) {
    EXPECT_TRUE(divisions({{0, 0}, {1, 0}, {3, 0}}).alike) << "the second child twice";
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {3, 0}}).lacking, 2u);
    EXPECT_FALSE(divisions({{0, 0}, {1, 0}, {4, 0}}).alike) << "the second, then the first";
    EXPECT_FALSE(divisions({{0, 0}, {1, 0}, {1, 2}}).alike) << "of A, then of B";
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {4, 0}}).first.child, 2u);
}

TEST(DivisionCheck, ATraversalThatBeginsAgainComesToOneChildAtATime) {
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {0, 0}, {2, 0}}).lacking, 0u);
    EXPECT_EQ(divisions({{0, 0}, {1, 0}, {0, 0}, {1, 0}}).lacking, 1u);
}

/// The same of a row against itself.
DivisionCounts own_divisions(const std::vector<IndexPair>& tests) {
    Rows rows;
    rows.query.sides[1] = rows.query.sides[0];
    rows.query.self = true;
    rows.query.b_to_a = Pose{};
    rows.query.events.clear();
    for (const IndexPair nodes : tests)
        rows.query.events.push_back({Kind::volumes, 0, nodes.a, nodes.b});
    return check_divisions(rows.query, rows.judged().tests);
}

TEST(DivisionCheck, OfABodyAgainstItselfTheOrderOfTheNodesDoesNotMatter) {
    // Leaves are not tested against themselves.
    EXPECT_EQ(own_divisions({{0, 0}, {1, 1}, {1, 2}, {2, 2}, {3, 4}, {5, 6}}).lacking, 0u);
    EXPECT_EQ(own_divisions({{0, 0}, {1, 1}, {2, 1}, {2, 2}, {4, 3}, {6, 5}}).lacking, 0u);
    EXPECT_EQ(own_divisions({{0, 0}, {1, 1}}).lacking, 1u) << "what is below node 2";
}

}  // namespace
}  // namespace scb
