#include "render/overlay/overlay_shape.h"

#include <gtest/gtest.h>

#include "render/overlay/font_face.h"
#include "render/overlay/line_stroke.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(Svg, HasLinesAndLettersInTheirOrder) {
    Overlay overlay;
    OverlayShapes shapes;
    EXPECT_EQ(overlay.note_in(&shapes), nullptr);
    overlay.begin();
    overlay.rectangle({1, 2, 30, 40}, {255, 0, 16});
    const TextStyle style{20, FontWeight::medium, {0, 0, 0}, Align::right};
    overlay.text(100, 5, "a < b & \"c\"", style);
    const std::vector<ScreenPosition> points = {{0, 0}, {10, 20}, {30, 5}};
    draw_smooth_line(overlay, points, {0, 0, 255, 128}, 3);
    draw_smooth_line(overlay, std::vector<ScreenPosition>{{7, 8}}, {0, 0, 255}, 4);
    overlay.polygon(points, {9, 9, 9});
    const std::string text = svg_text(shapes, empty_picture(320, 200), nullptr);
    const std::vector<std::string> expected = {
        "viewBox=\"0 0 320 200\"",
        "<rect x=\"0\" y=\"0\" width=\"320\" height=\"200\" fill=\"#ffffff\"/>",
        "<rect x=\"1\" y=\"2\" width=\"30\" height=\"40\" fill=\"#ff0010\"/>",
        ">a &lt; b &amp; &quot;c&quot;</text>",
        "<polyline points=\"0.00,0.00 10.00,20.00 30.00,5.00\" fill=\"none\" stroke=\"#0000ff\" "
        "stroke-opacity=\"0.502\" stroke-width=\"3.00\" stroke-linecap=\"round\"",
        "<circle cx=\"7.00\" cy=\"8.00\" r=\"2.00\" fill=\"#0000ff\"/>",
        "<polygon points=\"0.00,0.00 10.00,20.00 30.00,5.00\" fill=\"#090909\"/>",
        "</svg>"};
    std::size_t at = 0;
    for (const std::string& part : expected) {
        at = text.find(part, at);
        ASSERT_NE(at, std::string::npos) << part << "\n" << text;
    }
    // The pixels of smooth lines are not in it.
    EXPECT_EQ(count(text, "<rect"), 2U);
    // Aligned by what the overlay measures, which other faces are stretched to.
    const int width = overlay.measure("a < b & \"c\"", style).width;
    EXPECT_EQ(count(text, "<text x=\"" + std::to_string(100 - width) + "\""), 1U);
    EXPECT_EQ(count(text, "textLength=\"" + std::to_string(width) + "\""), 1U);
    overlay.begin();
    EXPECT_TRUE(shapes.list.empty());
}

TEST(Svg, HasTheViewsOfTheSceneAsAnImage) {
    Image views{2, 1, {1, 2, 3, 255, 4, 5, 6, 255}};
    const std::string with = svg_text({}, empty_picture(2, 1), &views),
                      without = svg_text({}, empty_picture(2, 1), nullptr);
    EXPECT_EQ(count(with, "<image width=\"2\" height=\"1\" xlink:href=\"data:image/png;base64,"),
              1U);
    EXPECT_EQ(count(without, "<image"), 0U);
}

}  // namespace
}  // namespace scb::render
