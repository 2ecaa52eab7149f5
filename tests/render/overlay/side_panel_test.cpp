#include "render/overlay/side_panel.h"

#include <gtest/gtest.h>

#include "render/plots/ending_colors.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

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
    // One of two lines is left out as a whole.
    const PanelNote two_lines{"a note that is too long for a single line of a panel so narrow"};
    EXPECT_EQ(filled(25 + 41, {PanelRow{"first", {}}, two_lines}), 25);
    EXPECT_EQ(filled(25 + 42, {PanelRow{"first", {}}, two_lines}), 25 + 42);
    EXPECT_EQ(filled(30, {PanelHeading{"a"}}), 30);
    // Heads of columns alone say nothing.
    const std::vector<PanelItem> columns = {PanelHeading{"a"}, PanelRow{"", {"tests"}},
                                            PanelRow{"b", {"1"}}};
    EXPECT_EQ(filled(30 + 25 + 24, columns), 0);
    EXPECT_EQ(filled(30 + 25 + 25, columns), 30 + 25 + 25);
}

TEST(SidePanel, LeavesOutWhatBelongsToAHeadingThatIsNotDrawn) {
    // The note alone would fit.
    EXPECT_EQ(filled(50, {PanelRow{"first", {}}, PanelHeading{"heading"}, PanelRow{"second", {}},
                          PanelNote{"a note"}}),
              25);
}

/// A picture that is nothing but the panel.
Image panel_image(Drawing& drawing, int width, const std::vector<PanelItem>& items) {
    constexpr int height = 60;
    Overlay overlay;
    overlay.begin();
    draw_side_panel(overlay, {0, 0, width, height}, light_theme, 20, items);
    return drawing.renderer.draw(empty_picture(width, height), &overlay).image;
}

TEST(SidePanel, SaysHowManyRowsAreLeftOut) {
    Drawing drawing;
    const PanelRow first{"first", {"1"}}, second{"second", {"2"}}, third{"third", {"3"}};
    EXPECT_EQ(panel_image(drawing, 300, {first, second, third}),
              panel_image(drawing, 300, {first, PanelRow{"… 2 more", {}}}));
    EXPECT_EQ(panel_image(drawing, 300, {first, second}),
              panel_image(drawing, 300, {first, second, PanelNote{"a note that has no room"}}));
}

TEST(SidePanel, CutsNoDifference) {
    Drawing drawing;
    const auto drawn = [&drawing](const std::string& difference) {
        return panel_image(drawing, 240,
                           {PanelRow{"pairs", {"8,234,567", difference}, {}, true},
                            PanelRow{"outlined", {"1", ""}}});
    };
    // Wider than half of the room beside the label, and wider than all of the room.
    for (const std::string number : {"280,12", "2,345,678,90"})
        for (const std::string sign : {"+", "−"})
            EXPECT_NE(drawn(sign + number + "4"), drawn(sign + number + "7")) << sign << number;
    EXPECT_NE(drawn("±0"), drawn("+1"));
}

TEST(SidePanel, CutsNoNameOfAStage) {
    Drawing drawing;
    const auto drawn = [&drawing](const std::string& name) {
        // As wide as in a picture of 1280x720.
        return panel_image(drawing, 300, {PanelLegendRow{body_a_color, name, "123,456", "28.9 %"}});
    };
    for (const VolumeKind kind : all_volume_kinds())
        for (const EndingGroup& group : ending_groups(endings_of(kind, {}), light_theme)) {
            const std::string name(group.label);
            EXPECT_NE(drawn(name), drawn(name.substr(0, name.size() - 1) + "w")) << name;
        }
}

TEST(SidePanel, WrapsALongNameOfAStageWhereThereIsRoom) {
    const PanelLegendRow stage{body_a_color, "centers farther apart than the sum of radii", "1,234",
                               "28.9 %"};
    const PanelRow row{"row", {"1"}};
    const PanelNote note{"a note"};
    // Its second line is 21 pixels high.
    EXPECT_EQ(filled(200, {stage, row}), 25 + 21 + 25);
    EXPECT_EQ(filled(25 + 21 + 25, {stage, row}), 25 + 21 + 25);
    EXPECT_EQ(filled(25 + 21 + 24, {stage, row}), 25 + 25) << "rows do not give way";
    EXPECT_EQ(filled(25 + 21 + 20, {stage, note}), 25 + 21) << "notes do";
    EXPECT_EQ(filled(200, {PanelLegendRow{body_a_color, "ball A, ball B", "1,234", "28.9 %"}}), 25);
    EXPECT_EQ(filled(200, {PanelLegendRow{body_a_color, std::string(80, 'm'), "1", ""}}), 25);
    // What is kept free stays so.
    Overlay overlay;
    overlay.begin();
    EXPECT_EQ(draw_side_panel(overlay, {0, 0, 300, 60}, light_theme, 20, {stage}, 15), 25);
    Drawing drawing;
    const auto drawn = [&](const std::string& name) {
        return panel_image(drawing, 300, {PanelLegendRow{body_a_color, name, "1,234", "28.9 %"}});
    };
    EXPECT_NE(drawn(stage.text), drawn("centers farther apart than the sum of radix"));
}

}  // namespace
}  // namespace scb::render
