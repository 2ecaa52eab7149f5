#include "golden/compare/worst_pixels.h"

#include <gtest/gtest.h>

namespace scb::golden {
namespace {

render::Image black(int width, int height) {
    return {width, height,
            std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height))};
}

constexpr PixelBox whole{0, 0, 5, 4};

TEST(WorstPixels, AreThoseOfTheLargestChangeInOneChannelFromTheTop) {
    const render::Image before = black(5, 4);
    render::Image after = before;
    render::set_pixel(after, 3, 3, {0, 0, 9, 0});
    render::set_pixel(after, 4, 1, {2, 2, 2, 2});  // more in all, but less in one
    render::set_pixel(after, 1, 2, {9, 0, 0, 0});
    render::set_pixel(after, 0, 0, {0, 1, 0, 0});
    render::set_pixel(after, 2, 2, {0, 0, 0, 9});
    const std::vector<PixelChange> worst = worst_pixels(before, after, whole, 4);
    ASSERT_EQ(worst.size(), 4u);
    const int expected[][2] = {{1, 2}, {2, 2}, {3, 3}, {4, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(worst[i].x, expected[i][0]) << i;
        EXPECT_EQ(worst[i].y, expected[i][1]) << i;
    }
    EXPECT_EQ(worst[1].by(), (std::array{0, 0, 0, 9}));
    EXPECT_EQ(worst_pixels(after, before, whole, 4)[1].by(), (std::array{0, 0, 0, -9}));
    EXPECT_EQ(worst_pixels(after, before, whole, 4)[1].most(), 9);
}

TEST(WorstPixels, AreNoMoreThanDiffer) {
    const render::Image before = black(5, 4);
    EXPECT_TRUE(worst_pixels(before, before, whole, 3).empty());
    render::Image after = before;
    render::set_pixel(after, 4, 3, {1, 0, 0, 0});
    EXPECT_EQ(worst_pixels(before, after, whole, 3).size(), 1u);
    EXPECT_TRUE(worst_pixels(before, after, whole, 0).empty());
}

TEST(WorstPixels, AreOfThePartThatIsAskedFor) {
    const render::Image before = black(5, 4);
    render::Image after = before;
    render::set_pixel(after, 4, 0, {9, 0, 0, 0});
    render::set_pixel(after, 1, 2, {1, 0, 0, 0});
    const std::vector<PixelChange> worst = worst_pixels(before, after, {0, 1, 3, 100}, 4);
    ASSERT_EQ(worst.size(), 1u);
    EXPECT_EQ(worst[0].y, 2);
}

}  // namespace
}  // namespace scb::golden
