#include "render/outline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scb {
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

}  // namespace
}  // namespace scb
