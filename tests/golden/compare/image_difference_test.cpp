#include "golden/compare/image_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>

#include "render/view/palette.h"

namespace scb::golden {
namespace {

render::Image filled(int width, int height, render::Rgba8 color) {
    render::Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) render::set_pixel(image, x, y, color);
    return image;
}

/// A copy in which some pixels are others, most by little.
render::Image disturbed(render::Image image, std::mt19937& random) {
    const std::size_t changes = random() % 40;
    for (std::size_t i = 0; i < changes && !image.rgba.empty(); ++i) {
        std::uint8_t& channel = image.rgba[random() % image.rgba.size()];
        channel = static_cast<std::uint8_t>(channel + (random() % 2 ? 1 : random() % 256));
    }
    return image;
}

render::Image noise(int width, int height, std::mt19937& random) {
    render::Image image = filled(width, height, {});
    for (std::uint8_t& channel : image.rgba) channel = static_cast<std::uint8_t>(random());
    return image;
}

int difference_at(const render::Image& a, const render::Image& b, int x, int y) {
    const render::Rgba8 p = render::pixel(a, x, y), q = render::pixel(b, x, y);
    return std::max(
        {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b), std::abs(p.a - q.a)});
}

/// The same by definition: one pass over the picture for every number.
ImageDifference recount(const render::Image& a, const render::Image& b) {
    ImageDifference difference;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const int by = difference_at(a, b, x, y);
            difference.largest = std::max(difference.largest, by);
            if (by > 0) ++difference.pixels;
            if (by > 0) difference.box.add(x, y);
            for (int d = 0; d < 256; ++d)
                if (by > d) ++difference.beyond[static_cast<std::size_t>(d)];
        }
    return difference;
}

TEST(ImageDifference, FindsOnePixelOffByOneInAnyChannel) {
    const render::Image a = filled(512, 512, {10, 20, 30, 200});
    for (std::size_t channel = 0; channel < 4; ++channel)
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(511, 511), std::pair(310, 17)})
            for (const int step : {-1, 1}) {
                render::Image b = a;
                std::uint8_t& value =
                    b.rgba[4 * (512 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)) +
                           channel];
                value = static_cast<std::uint8_t>(value + step);
                ImageDifference expected;
                expected.pixels = 1;
                expected.box = {x, y, x + 1, y + 1};
                expected.largest = 1;
                expected.beyond[0] = 1;
                EXPECT_EQ(image_difference(a, b), expected) << x << " " << y << " " << channel;
                EXPECT_EQ(image_difference(b, a), expected) << x << " " << y << " " << channel;
            }
}

TEST(ImageDifference, IsNoneForEqualAndForEmptyPictures) {
    std::mt19937 random(1);
    const render::Image image = noise(33, 17, random);
    EXPECT_EQ(image_difference(image, image), ImageDifference{});
    EXPECT_TRUE(image_difference(image, image).box.empty());
    EXPECT_EQ(image_difference({}, {}), ImageDifference{});
    EXPECT_EQ(image_difference({0, 5, {}}, {0, 5, {}}), ImageDifference{});
}

TEST(ImageDifference, AgreesWithANaiveRecount) {
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) {
        const int width = 1 + static_cast<int>(random() % 40),
                  height = 1 + static_cast<int>(random() % 40);
        const render::Image a = noise(width, height, random);
        const render::Image b = i % 3 == 0 ? noise(width, height, random) : disturbed(a, random);
        ASSERT_EQ(image_difference(a, b), recount(a, b)) << i;
    }
}

TEST(ImageDifference, FindsTheWholeRange) {
    const render::Image black = filled(3, 2, {0, 0, 0, 255}),
                        white = filled(3, 2, {255, 255, 255, 255});
    const ImageDifference difference = image_difference(black, white);
    EXPECT_EQ(difference.largest, 255);
    EXPECT_EQ(difference.beyond[254], 6u);
    EXPECT_EQ(difference.beyond[255], 0u);
    EXPECT_EQ(difference.box, (PixelBox{0, 0, 3, 2}));
}

TEST(ColorTolerance, AllowsWhatItDeclaresAndNoMore) {
    render::Image a = filled(8, 8, {100, 100, 100, 255}), b = a;
    EXPECT_TRUE(within(image_difference(a, b), {}));
    for (int x = 0; x < 5; ++x) render::set_pixel(b, x, 3, {103, 100, 100, 255});
    render::set_pixel(b, 7, 7, {100, 110, 100, 255});
    const ImageDifference difference = image_difference(a, b);
    EXPECT_FALSE(within(difference, {}));
    EXPECT_FALSE(within(difference, {0, 5}));
    EXPECT_TRUE(within(difference, {0, 6}));
    EXPECT_FALSE(within(difference, {2, 5}));
    EXPECT_FALSE(within(difference, {3, 0}));
    EXPECT_TRUE(within(difference, {3, 1}));
    EXPECT_FALSE(within(difference, {9, 0}));
    EXPECT_TRUE(within(difference, {10, 0}));
    EXPECT_TRUE(within(difference, {255, 0}));
}

/// How far a color is from grey.
int saturation(render::Rgba8 color) {
    return std::max({color.r, color.g, color.b}) - std::min({color.r, color.g, color.b});
}

TEST(DifferencePicture, ColorsEveryPixelThatDiffersAndNoOther) {
    std::mt19937 random(3);
    const render::Image a = noise(40, 30, random), b = disturbed(disturbed(a, random), random);
    const render::Image picture = difference_picture(a, b);
    ASSERT_EQ(picture.width, 40);
    ASSERT_EQ(picture.height, 30);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const render::Rgba8 color = render::pixel(picture, x, y);
            EXPECT_EQ(color.a, 255);
            if (difference_at(a, b, x, y) > 0)
                EXPECT_GE(saturation(color), 160);
            else
                EXPECT_TRUE(saturation(color) == 0 && color.r >= 190);
        }
}

TEST(DifferencePicture, IsStrongerWhereTheyDifferMore) {
    render::Image a = filled(256, 1, {0, 0, 0, 255}), b = a;
    for (int x = 0; x < 256; ++x)
        render::set_pixel(b, x, 0, {static_cast<std::uint8_t>(x), 0, 0, 255});
    const render::Image picture = difference_picture(a, b);
    for (int x = 2; x < 256; ++x)
        EXPECT_GE(saturation(render::pixel(picture, x, 0)),
                  saturation(render::pixel(picture, x - 1, 0)));
    EXPECT_EQ(render::pixel(picture, 255, 0), render::changed_color);
}

TEST(ChangedClusters, AreBoxesOfNearPixels) {
    const render::Image before = filled(200, 100, {9, 9, 9, 255});
    EXPECT_TRUE(changed_clusters(difference_picture(before, before), 16).empty());
    render::Image after = before;
    for (const auto& [x, y] : {std::pair{0, 0}, {150, 99}, {199, 99}, {192, 96}})
        render::set_pixel(after, x, y, {10, 9, 9, 255});
    const render::Image difference = difference_picture(before, after);
    EXPECT_EQ(changed_clusters(difference, 16),
              (std::vector<PixelBox>{{0, 0, 1, 1}, {150, 99, 151, 100}, {192, 96, 200, 100}}));
    EXPECT_EQ(changed_clusters(difference, 2),
              (std::vector<PixelBox>{{0, 0, 1, 1}, {150, 96, 200, 100}}));
    EXPECT_EQ(changed_clusters(difference, 1), (std::vector<PixelBox>{{0, 0, 200, 100}}));
}

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
