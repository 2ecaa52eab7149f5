#include "render/overlay/overlay.h"

#include "render/overlay/font_face.h"
#include "render/overlay/scales.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

TEST(Overlay, TextStaysInItsMeasuredBox) {
    Drawing drawing;
    Overlay overlay;
    for (const Align align : {Align::left, Align::center, Align::right})
        for (const int size : {13, 20, 28})
            for (const FontWeight weight :
                 {FontWeight::regular, FontWeight::medium, FontWeight::bold}) {
                const TextStyle style{size, weight, {0, 0, 0}, align};
                const std::string_view text = "Level 7 — τ ≤ 2r, Ägäis × 3² (jg)";
                overlay.begin();
                overlay.text(400, 30, text, style);
                const TextSize box = overlay.measure(text, style);
                const int shift =
                    align == Align::left ? 0 : (align == Align::center ? box.width / 2 : box.width);
                const Picture picture = empty_picture(800, 100);
                const Image image = drawing.renderer.draw(picture, &overlay).image;
                const auto [inside, outside] = inside_and_outside(
                    image, {400 - shift, 30, box.width, box.height}, picture.background);
                EXPECT_GT(inside, 100);
                EXPECT_EQ(outside, 0) << size;
            }
}

TEST(Overlay, TheFaceHasTheSignsThatLegendsUse) {
    Overlay overlay;
    const TextStyle style{20, FontWeight::regular, {0, 0, 0}, Align::left};
    overlay.text(0, 0, "x", style);
    const ImFont* font = overlay.faces()[0].font;
    for (const ImWchar sign :
         std::initializer_list<ImWchar>{0x03C4, 0x0394, 0x03B1, 0x00D7, 0x2264, 0x2265, 0x00B2,
                                        0x00B3, 0x2013, 0x2014, 0x2026, 0x00B7, 0x2212})
        EXPECT_NE(font->FindGlyphNoFallback(sign), nullptr) << std::hex << sign;
}

TEST(Overlay, RectanglesCoverExactlyTheirPixels) {
    Drawing drawing;
    Overlay overlay;
    const PixelRect rect{13, 7, 21, 11};
    overlay.rectangle(rect, {10, 20, 30});
    overlay.frame({50, 5, 20, 20}, {200, 0, 0});
    const Picture picture = empty_picture(100, 40);
    const Image image = drawing.renderer.draw(picture, &overlay).image;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 45; ++x)
            EXPECT_EQ(pixel(image, x, y),
                      contains(rect, x, y) ? (Rgba8{10, 20, 30}) : picture.background);
    EXPECT_EQ(pixel(image, 50, 5), (Rgba8{200, 0, 0}));
    EXPECT_EQ(pixel(image, 69, 24), (Rgba8{200, 0, 0}));
    EXPECT_EQ(pixel(image, 51, 6), picture.background);
}

TEST(Overlay, MoreRectanglesThanSixteenBitIndicesReach) {
    Drawing drawing;
    Overlay overlay;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            overlay.rectangle({x, y, 1, 1},
                              {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 9});
    const Image image = drawing.renderer.draw(empty_picture(200, 200), &overlay).image;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            ASSERT_EQ(pixel(image, x, y),
                      (Rgba8{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 9}));
}

TEST(Overlay, AnOverlayLeavesTheIdsAlone) {
    Drawing drawing;
    const Picture picture = picture_of({Ball{Vec3(0, 0, 0), 1}}, 100, 100, 1);
    Overlay overlay;
    overlay.rectangle({0, 0, 100, 100}, {0, 0, 0});
    EXPECT_EQ(drawing.renderer.draw(picture, &overlay, true).ids,
              drawing.renderer.draw(picture, nullptr, true).ids);
}

TEST(Figures, StayInThePixelsThatTheyReport) {
    Drawing drawing;
    Overlay overlay;
    FigureStyle style;
    const Picture picture = empty_picture(600, 400);
    const std::vector<Tick> ticks = {{0, "0"}, {0.5, "0.5"}, {1, "1"}};
    const std::vector<BarPart> parts = {{body_a_color, 1}, {body_b_color, 2}};
    const auto check = [&](const auto& draw) {
        overlay.begin();
        const PixelRect covered = draw();
        const auto [inside, outside] = inside_and_outside(
            drawing.renderer.draw(picture, &overlay).image, covered, picture.background);
        EXPECT_GT(inside, 0);
        EXPECT_EQ(outside, 0);
    };
    check([&] {
        return draw_color_bar(overlay, {100, 100, 300, 14}, viridis, "τ / 2r", ticks, style);
    });
    check([&] {
        return draw_color_bar(overlay, {100, 100, 14, 200}, viridis, "τ / 2r", ticks, style);
    });
    check([&] { return draw_stacked_bar(overlay, {100, 100, 300, 14}, parts, 3); });
    check([&] { return draw_scale_bar(overlay, 100, 100, 200, 123.4, style); });
}

TEST(Figures, StackedBarsShareTheirLength) {
    Drawing drawing;
    Overlay overlay;
    const std::vector<BarPart> parts = {{{10, 0, 0}, 1}, {{20, 0, 0}, 2}, {{30, 0, 0}, 1}};
    draw_stacked_bar(overlay, {0, 0, 80, 10}, parts, 8);
    const Image image = drawing.renderer.draw(empty_picture(100, 20), &overlay).image;
    const auto red = [&](int x) { return int{pixel(image, x, 5).r}; };
    EXPECT_EQ((std::array{red(0), red(9), red(10), red(29), red(30), red(39), red(40)}),
              (std::array{10, 10, 20, 20, 30, 30, 255}));
}

TEST(Palette, ViridisGrowsLighter) {
    EXPECT_EQ(viridis(0), (Rgba8{65, 68, 135}));
    EXPECT_EQ(viridis(1), (Rgba8{253, 231, 37}));
    EXPECT_EQ(viridis(-1), viridis(0));
    EXPECT_EQ(viridis(2), viridis(1));
    int last = 0;
    for (int i = 0; i <= 100; ++i) {
        const Rgba8 color = viridis(i / 100.0);
        const int luma = 299 * color.r + 587 * color.g + 114 * color.b;
        EXPECT_GE(luma, last);
        last = luma;
    }
}

TEST(TextUnit, GrowsWithThePictureAndStaysLegible) {
    EXPECT_EQ(text_unit(1280, 720), 20);
    EXPECT_EQ(text_unit(2560, 1440), 40);
    EXPECT_EQ(text_unit(640, 480), 13);
    EXPECT_EQ(text_unit(200, 100), 13);
}

}  // namespace
}  // namespace scb::render
