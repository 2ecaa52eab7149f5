#include "golden/compare/id_picture.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace scb::golden {
namespace {

render::IdImage row(std::vector<std::uint32_t> ids) {
    render::IdImage image;
    image.width = static_cast<int>(ids.size());
    image.height = 1;
    image.ids = std::move(ids);
    return image;
}

TEST(IdPicture, ShowsTheBackgroundAsNothingAndEachThingInAColorOfItsOwn) {
    std::vector<std::uint32_t> ids(200);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::uint32_t>(i);
    const render::Image shown = shown_ids(row(ids));
    EXPECT_EQ(render::pixel(shown, 0, 0), (render::Rgba8{0, 0, 0, 0}));
    std::set<std::tuple<int, int, int>> colors;
    for (int x = 1; x < shown.width; ++x) {
        const render::Rgba8 color = render::pixel(shown, x, 0);
        EXPECT_EQ(color.a, 255);
        colors.insert({color.r, color.g, color.b});
    }
    EXPECT_EQ(colors.size(), ids.size() - 1);
}

TEST(IdPicture, ShowsAThingInTheSameColorEverywhere) {
    const render::Image shown = shown_ids(row({7, 0xffffffffu, 7}));
    EXPECT_EQ(render::pixel(shown, 0, 0), render::pixel(shown, 2, 0));
    EXPECT_FALSE(render::pixel(shown, 0, 0) == render::pixel(shown, 1, 0));
}

TEST(IdPicture, MarksThePixelsWhoseOwnerDiffers) {
    const render::Image shown = shown_id_difference(row({1, 2, 0, 0, 5}), row({1, 3, 4, 0, 0}));
    const render::Rgba8 mark{213, 0, 70, 255};
    for (const int x : {1, 2, 4}) EXPECT_EQ(render::pixel(shown, x, 0), mark) << x;
    for (const int x : {0, 3}) {
        const render::Rgba8 color = render::pixel(shown, x, 0);
        EXPECT_EQ(color.r, color.g) << x;
        EXPECT_EQ(color.g, color.b) << x;
        EXPECT_GE(color.r, 205) << x;
    }
}

TEST(IdPicture, OfNothingIsNothing) {
    EXPECT_TRUE(shown_ids({}).rgba.empty());
    EXPECT_TRUE(shown_id_difference({}, {}).rgba.empty());
}

}  // namespace
}  // namespace scb::golden
