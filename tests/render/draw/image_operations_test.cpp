#include "render/draw/image_operations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "core/base/random.h"
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

constexpr std::size_t target_width = 300;

std::vector<std::uint32_t> random_words(std::size_t count) {
    Random random(7);
    std::vector<std::uint32_t> words(count);
    for (std::uint32_t& word : words)
        for (int shift = 0; shift < 32; shift += 8) {
            const double u = random.uniform(-0.2, 1.2);  // often one of the ends
            word |= static_cast<std::uint32_t>(u < 0 ? 0 : u > 1 ? 255 : 255 * u) << shift;
        }
    return words;
}

/// As they are in memory: r, g, b, a.
std::array<std::uint8_t, 4> bytes(std::uint32_t word) {
    return std::bit_cast<std::array<std::uint8_t, 4>>(word);
}

TEST(Resolve, ColorsAreTheRoundedMeanOfTheirSamplesAndOpaque) {
    for (const int scale : {1, 2}) {
        const auto step = static_cast<std::size_t>(scale);
        const std::vector<std::uint32_t> samples = random_words(step * step * target_width);
        std::vector<std::uint32_t> row(target_width);
        resolve_colors(samples.data(), scale, row);
        for (std::size_t x = 0; x < target_width; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                std::uint32_t sum = 0;
                for (std::size_t i = 0; i < step; ++i)
                    for (std::size_t k = 0; k < step; ++k)
                        sum += bytes(samples[i * step * target_width + step * x + k])[channel];
                const std::uint32_t count = scale == 1 ? 1 : 4;
                ASSERT_EQ(bytes(row[x])[channel], channel == 3 ? 255 : (sum + count / 2) / count)
                    << x;
            }
    }
}

TEST(Resolve, AnIdIsThatOfOneSample) {
    const std::vector<std::uint32_t> samples = random_words(4 * target_width);
    std::vector<std::uint32_t> row(target_width);
    resolve_ids(samples.data(), 1, row);
    EXPECT_TRUE(std::equal(row.begin(), row.end(), samples.begin()));
    resolve_ids(samples.data(), 2, row);
    for (std::size_t x = 0; x < target_width; ++x)
        ASSERT_EQ(row[x], samples[2 * target_width + 2 * x]);
}

}  // namespace

}  // namespace scb::render
