#include "core/judge/test_links.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

TEST(TestLinks, ATestIsLedToByTheLatestOfThoseAboveIt) {
    const Rows rows;
    TestLinks links(rows.query);
    EXPECT_EQ(links.take_volumes({0, 0}, true).led_by, no_index);
    EXPECT_EQ(links.take_volumes({0, 1}, true).led_by, 0u);
    EXPECT_EQ(links.take_volumes({1, 1}, true).led_by, 1u) << "not (0, 0), which is above it too";
    EXPECT_EQ(links.take_volumes({1, 0}, true).led_by, 0u);
    EXPECT_EQ(links.take_volumes({1, 1}, true).led_by, 3u) << "again, by the other way";
    EXPECT_EQ(links.take_volumes({3, 3}, true).led_by, 4u);
    EXPECT_EQ(links.take_volumes({5, 3}, true).led_by, no_index) << "nothing above was tested";
}

TEST(TestLinks, ATestHasTheParentThatItsEngineRecorded) {
    const Rows rows;
    TestLinks links(rows.query);
    links.take_volumes({0, 0}, true);
    links.take_volumes({1, 0}, true);
    EXPECT_EQ(links.take_volumes({1, 1}, true).led_by, 1u) << "the latest of those above it";
    EXPECT_EQ(links.take_volumes({1, 1}, true, 0).led_by, 0u);
    EXPECT_EQ(links.take_volumes({3, 1}, true, 1).led_by, 1u);
    EXPECT_EQ(links.led_to_items({0, 0}), 4u);
}

TEST(TestLinks, ATestThatIsMadeAgainIsTheLatestOfItsNodes) {
    const Rows rows;
    TestLinks links(rows.query);
    EXPECT_FALSE(links.take_volumes({3, 4}, true).repeated);
    EXPECT_FALSE(links.take_volumes({4, 3}, true).repeated) << "A's node and B's are exchanged";
    EXPECT_TRUE(links.take_volumes({3, 4}, true).repeated);
    EXPECT_EQ(links.test_of({3, 4}), 2u);
    EXPECT_EQ(links.test_of({4, 3}), 1u);
    EXPECT_EQ(links.test_of({4, 4}), std::nullopt);
}

TEST(TestLinks, NodesThatThereAreNotAreCountedAndLeadToNothing) {
    const Rows rows;
    TestLinks links(rows.query);
    for (int i = 0; i < 2; ++i) {
        const TestLinks::Link link = links.take_volumes({no_index, 3}, true);
        EXPECT_EQ(link.led_by, no_index);
        EXPECT_FALSE(link.repeated);
    }
    EXPECT_FALSE(links.strays({0, 0})) << "nothing is known of the latest";
    links.take_volumes({3, 3}, false);
    EXPECT_EQ(links.test_of({3, 3}), 2u);
}

TEST(TestLinks, ATestOfItemsIsLedToByThatOfTheirNodesOrElseByTheLatestThatPassed) {
    const Rows rows;
    TestLinks links(rows.query);
    EXPECT_EQ(links.led_to_items({0, 0}), no_index);
    links.take_volumes({3, 3}, true);
    links.take_volumes({4, 4}, true);
    links.take_volumes({5, 5}, false);
    EXPECT_EQ(links.led_to_items({0, 0}), 0u);
    EXPECT_EQ(links.led_to_items({2, 2}), 2u) << "the test of their own nodes, though it rejected";
    EXPECT_EQ(links.led_to_items({0, 3}), 1u);
    EXPECT_TRUE(links.tested_nodes_of({2, 2}));
    EXPECT_FALSE(links.tested_nodes_of({0, 3}));
}

TEST(TestLinks, ItemsStrayThatAreInNeitherTheLatestLeavesNorOthersThatWereTested) {
    const Rows rows;
    TestLinks links(rows.query);
    links.take_volumes({3, 3}, true);
    links.take_volumes({4, 4}, true);
    links.take_volumes({6, 6}, false);
    EXPECT_FALSE(links.strays({1, 1}));
    EXPECT_FALSE(links.strays({0, 0}));
    EXPECT_TRUE(links.strays({1, 0}));
    EXPECT_TRUE(links.strays({0, 1}));
    EXPECT_TRUE(links.strays({2, 2}));
    links.take_volumes({1, 4}, true);
    EXPECT_FALSE(links.strays({2, 2})) << "engines may go on from an inner node by themselves";
}

}  // namespace
}  // namespace scb
