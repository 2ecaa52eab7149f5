#include "core/analysis/outcome.h"

#include <gtest/gtest.h>

#include "core/analysis/traversal_part.h"
#include "tests/core/analysis/made_query.h"

namespace scb {
namespace {

constexpr std::uint32_t no_parent = MadeQuery::none;

TEST(EngineOutcomes, ADivisionIsOfTheNodeWhoseChildrenAreTested) {
    MadeQuery query;
    query.test(no_parent, {0, 0});
    query.test(0, {1, 0});
    query.test(0, {2, 0});
    query.test(1, {1, 5});
    query.test(2, {3, 6});
    query.test(3, {1, 7});
    query.test(3, {8, 5});
    query.test(5, {9, 9}, false);
    EXPECT_EQ(
        query.outcomes(),
        (std::vector{Stage::divided_a, Stage::divided_b, Stage::divided_both, Stage::divided_both,
                     Stage::left_over, Stage::divided_both, Stage::left_over, Stage::ball_ball}));
}

TEST(EngineOutcomes, LeavesMeetWhereSomeOfTheirTrianglesDo) {
    for (const auto& [tests, outcome] :
         {std::pair(std::vector{false, true, false}, Stage::triangles_meet),
          {std::vector{true, false}, Stage::triangles_meet},
          {std::vector{false, false}, Stage::triangles_apart}}) {
        MadeQuery query;
        query.test(no_parent, {0, 0});
        for (std::uint32_t i = 0; i < tests.size(); ++i) query.triangles({i, i}, tests[i]);
        EXPECT_EQ(query.outcomes()[0], outcome);
    }
}

TEST(EngineOutcomes, ARejectionStaysOneWhateverTheEngineTestsAfterIt) {
    MadeQuery query;
    query.test(no_parent, {0, 0}, false);
    query.triangles({0, 0}, true);
    query.test(0, {1, 0});
    EXPECT_EQ(query.outcomes()[0], Stage::ball_ball);
}

TEST(Outcomes, TrianglesThatShareAVertexAreNeighbors) {
    MadeQuery query;
    query.test(no_parent, {0, 0});
    query.triangles({0, 1}, false);
    query.frame.steps.items.back().neighbors = true;
    EXPECT_EQ(query.outcomes(), Outcomes{Stage::neighbors});
}

TEST(EngineOutcomes, PairsOfObjectsAreFound) {
    MadeQuery query;
    query.header.engine->objects = true;
    query.test(no_parent, {0, 0});
    query.test(0, {1, 2});
    query.test(0, {2, 1});
    query.frame.found.pairs = {{1, 2}};
    EXPECT_EQ(query.outcomes(), (std::vector{Stage::divided_both, Stage::found, Stage::left_over}));
}

TEST(TestSizes, OfSeveralRootsEachHasItsOwn) {
    MadeQuery query;
    query.test(no_parent, {0, 0});
    query.test(0, {1, 0});
    query.test(no_parent, {5, 5});
    query.test(2, {6, 5});
    query.test(3, {7, 5});
    EXPECT_EQ(subtree_sizes(query.frame.steps), (std::vector<std::uint32_t>{2, 1, 3, 2, 1}));
}

}  // namespace
}  // namespace scb
