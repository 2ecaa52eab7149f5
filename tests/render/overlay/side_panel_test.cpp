#include "render/overlay/side_panel.h"

#include <gtest/gtest.h>

namespace scb::render {
namespace {

/// How much of a panel of that height is filled; lines of text are 25 pixels high.
int filled(int height, const std::vector<PanelItem>& items) {
    Overlay overlay;
    overlay.begin();
    return draw_side_panel(overlay, {0, 100, 300, height}, light_theme, 20, items) - 100;
}

TEST(SidePanel, HasNoHeadingWithoutWhatStandsBelowIt) {
    const std::vector<PanelItem> items = {PanelRow{"first", {"1"}}, PanelHeading{"heading"},
                                          PanelRow{"second", {"2"}}, PanelRow{"third", {"3"}}};
    // A row; a gap of 10, a heading with its line, a row.
    EXPECT_EQ(filled(24, items), 0);
    EXPECT_EQ(filled(25 + 10 + 30 + 24, items), 25);
    EXPECT_EQ(filled(25 + 10 + 30 + 25, items), 25 + 10 + 30 + 25);
    EXPECT_EQ(filled(200, items), 25 + 10 + 30 + 25 + 25);
    // Above another heading it needs that one's row.
    EXPECT_EQ(filled(84, {PanelHeading{"a"}, PanelHeading{"b"}, PanelRow{"c", {}}}), 0);
    EXPECT_EQ(filled(70, {PanelHeading{"a"}, PanelScale{"scale", {}}}), 0);
    // A note is small enough.
    EXPECT_EQ(filled(52, {PanelHeading{"a"}, PanelScale{"scale", {}}, PanelNote{"b"}}), 51);
    EXPECT_EQ(filled(30, {PanelHeading{"a"}}), 30);
}

TEST(SidePanel, LeavesOutWhatBelongsToAHeadingThatIsNotDrawn) {
    // The note alone would fit.
    EXPECT_EQ(filled(50, {PanelRow{"first", {}}, PanelHeading{"heading"}, PanelRow{"second", {}},
                          PanelNote{"a note"}}),
              25);
}

}  // namespace
}  // namespace scb::render
