#include "render/figures/figure_words.h"

#include <gtest/gtest.h>

namespace scb::render {
namespace {

using Names = std::vector<std::string>;

TEST(BodyNames, AreLettersWhereAColumnHasNoRoomForThem) {
    std::vector<PanelItem> items;
    EXPECT_EQ(column_names(items, {"bracket", "pin"}), (Names{"bracket", "pin"}));
    EXPECT_EQ(column_names(items, {"A", "B"}), (Names{"A", "B"}));
    EXPECT_EQ(column_names(items, {"A", "B"}, true), (Names{"A", "B"}));
    EXPECT_TRUE(items.empty());
    EXPECT_EQ(column_names(items, {"spider", "ultimaker_robot_support"}), (Names{"A", "B"}));
    ASSERT_EQ(items.size(), 1u);
    EXPECT_EQ(std::get<PanelNote>(items[0]).text, "A spider, B ultimaker_robot_support");
    EXPECT_EQ(column_names(items, {"bracket", "pin"}, true), (Names{"A", "B"}));
    EXPECT_EQ(std::get<PanelNote>(items.back()).text, "A bracket, B pin");
}

}  // namespace
}  // namespace scb::render
