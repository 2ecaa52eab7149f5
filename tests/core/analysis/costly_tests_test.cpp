#include "core/analysis/costly_tests.h"

#include <gtest/gtest.h>

#include "tests/core/analysis/made_query.h"

namespace scb {
namespace {

TEST(CostlyTests, AreThoseThatAreNamedThenThoseWithTheMostBelow) {
    // 0 led to 1 and 4, 1 to 2 and 3, 4 to 5.
    const Steps steps = steps_with_parents({no_step, 0, 1, 1, 0, 4});
    using Tests = std::vector<std::uint32_t>;
    EXPECT_EQ(costly_tests(steps, {}, 3), (Tests{0, 1, 4}));
    EXPECT_EQ(costly_tests(steps, Tests{5, 3}, 3), (Tests{0, 3, 5}));
    EXPECT_EQ(costly_tests(steps, Tests{5, 3}, 1), (Tests{5}));
    EXPECT_EQ(costly_tests(steps, Tests{0}, 2), (Tests{0, 1}));
    EXPECT_EQ(costly_tests(steps, {}, 100), (Tests{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(costly_tests(steps, {}, 0), (Tests{}));
}

}  // namespace
}  // namespace scb
