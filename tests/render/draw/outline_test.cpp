#include "render/draw/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "render/draw/pane_difference.h"
#include "render/overlay/font_face.h"
#include "render/overlay/overlay.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

constexpr Rgba8 before{10, 20, 30, 255}, ring{1, 2, 3, 255}, halo{200, 201, 202, 255};

Image filled(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        for (const std::uint8_t channel : {before.r, before.g, before.b, before.a})
            image.rgba.push_back(channel);
    return image;
}

IdImage no_ids(int width, int height) {
    return {width, height,
            std::vector<std::uint32_t>(static_cast<std::size_t>(width) *
                                       static_cast<std::size_t>(height))};
}

void set_id(IdImage& image, int x, int y, std::uint32_t id) {
    image.ids[static_cast<std::size_t>(y * image.width + x)] = id;
}

TEST(Outline, IsARingAndAHaloAroundWhatIsOutlined) {
    IdImage ids = no_ids(30, 20);
    for (int y = 8; y < 12; ++y)
        for (int x = 10; x < 20; ++x) set_id(ids, x, y, x < 15 ? 5u : 7u);
    set_id(ids, 3, 3, 6);
    Image image = filled(30, 20);
    draw_outline(image, ids, {0, 0, 30, 20}, {{5, 7}, ring, halo, 2});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x) {
            const int dx = std::max({10 - x, 0, x - 19}), dy = std::max({8 - y, 0, y - 11});
            const int squared = dx * dx + dy * dy;
            const Rgba8 expected = squared == 0   ? before  // also between the two
                                   : squared <= 4 ? ring
                                   : squared <= 9 ? halo
                                                  : before;
            EXPECT_EQ(pixel(image, x, y), expected) << x << " " << y;
        }
}

TEST(Outline, StaysWithinItsPane) {
    IdImage ids = no_ids(12, 8);
    set_id(ids, 5, 4, 9);
    set_id(ids, 6, 4, 9);
    Image image = filled(12, 8);
    draw_outline(image, ids, {0, 0, 6, 8}, {{9}, ring, halo, 1});
    EXPECT_EQ(pixel(image, 4, 4), ring);
    for (int y = 0; y < 8; ++y)
        for (int x = 6; x < 12; ++x) EXPECT_EQ(pixel(image, x, y), before);
}

TEST(Outline, OfNothingLeavesThePictureAsItIs) {
    IdImage ids = no_ids(8, 8);
    set_id(ids, 4, 4, 9);
    Image image = filled(8, 8);
    draw_outline(image, ids, {0, 0, 8, 8}, {{8, 10}, ring, halo, 2});
    EXPECT_EQ(image, filled(8, 8));
}

/// Two views of a ball that they share and one that they do not, which reaches out of its view.
Picture two_views(int samples) {
    Picture picture = picture_of({Ball{Vec3(0, 0, 0), 1}}, 200, 100, samples);
    Pane& pane = picture.panes[0];
    pane.camera =
        fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), 1}}),
                   {1, 0.04, true, 30});
    set_depth_range(pane.camera, support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), 2}}));
    pane.viewport = {10, 10, 80, 80};
    picture.panes.push_back(pane);
    picture.panes[1].viewport.x = 110;
    for (const int side : {0, 1})
        picture.panes[static_cast<std::size_t>(side)].volumes.push_back(
            {Ball{Vec3(side == 0 ? 1 : -1, -1, 0), 0.5}, before,
             static_cast<std::uint32_t>(2 + side)});
    const std::vector<std::uint32_t> ids = differing_ids(picture.panes[0], picture.panes[1]);
    for (Pane& view : picture.panes) view.outline = {ids, ring, halo, 2};
    return picture;
}

/// How many pixels have that color: in either pane, and outside them.
std::array<int, 3> count_of(Rgba8 color, const Image& image, const Picture& picture) {
    std::array<int, 3> counts{};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (pixel(image, x, y) == color)
                ++counts[contains(picture.panes[0].viewport, x, y)   ? 0
                         : contains(picture.panes[1].viewport, x, y) ? 1
                                                                     : 2];
    return counts;
}

TEST(Outline, IsDrawnInEveryPaneThatHasOne) {
    Drawing drawing;
    for (const int samples : {1, 4}) {
        const Picture picture = two_views(samples);
        const Rendering rendering = drawing.renderer.draw(picture);
        EXPECT_FALSE(rendering.ids);
        for (const Rgba8 color : {ring, halo}) {
            const std::array<int, 3> counts = count_of(color, rendering.image, picture);
            EXPECT_GT(counts[0], 50);
            EXPECT_GT(counts[1], 50);
            EXPECT_EQ(counts[2], 0);
        }
        const Rendering with_ids = drawing.renderer.draw(picture, nullptr, true);
        EXPECT_TRUE(with_ids.ids);
        EXPECT_EQ(with_ids.image, rendering.image);
    }
}

TEST(Outline, IsBelowTheOverlay) {
    Drawing drawing;
    Overlay overlay;
    const Rgba8 ink{250, 10, 10};
    overlay.text(40, 20, "MMM", {60, FontWeight::bold, ink, Align::left});
    for (const int samples : {1, 4}) {
        const Picture picture = two_views(samples);
        const Image text = drawing.renderer.draw(empty_picture(200, 100), &overlay).image,
                    outline = drawing.renderer.draw(picture).image,
                    both = drawing.renderer.draw(picture, &overlay).image;
        int covered = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 200; ++x) {
                if (pixel(text, x, y) != ink) continue;
                EXPECT_EQ(pixel(both, x, y), ink) << x << " " << y;
                covered += pixel(outline, x, y) == ring;
            }
        EXPECT_GT(covered, 5);
    }
}

}  // namespace
}  // namespace scb::render
