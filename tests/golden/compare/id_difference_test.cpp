#include "golden/compare/id_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "golden/compare/image_difference.h"
#include "render/view/palette.h"

namespace scb::golden {
namespace {

render::IdImage empty_picture(int width, int height) {
    render::IdImage image{width, height, {}};
    image.ids.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return image;
}

void fill(render::IdImage& image, PixelBox box, std::uint32_t id) {
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            image.ids[static_cast<std::size_t>(y * image.width + x)] = id;
}

/// The same by definition, thing by thing.
IdDifference recount(const render::IdImage& before, const render::IdImage& after) {
    IdDifference difference;
    std::map<std::uint32_t, IdChange> changes;
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const std::uint32_t b = render::pixel(before, x, y), a = render::pixel(after, x, y);
            ++changes[b].before;
            ++changes[a].after;
            if (a == b) continue;
            ++difference.pixels;
            difference.box.add(x, y);
            for (const std::uint32_t id : {a, b}) {
                ++changes[id].moved;
                changes[id].box.add(x, y);
            }
        }
    for (auto& [id, change] : changes) {
        change.id = id;
        if (id != 0 && change.moved > 0) difference.changes.push_back(change);
    }
    // Stable sorts, the least important key first.
    std::stable_sort(difference.changes.begin(), difference.changes.end(),
                     [](const IdChange& a, const IdChange& b) { return a.moved > b.moved; });
    std::stable_partition(difference.changes.begin(), difference.changes.end(),
                          [](const IdChange& c) { return c.before == 0 || c.after == 0; });
    return difference;
}

TEST(IdDifference, IsNoneForEqualPictures) {
    render::IdImage image = empty_picture(20, 10);
    fill(image, {3, 3, 9, 8}, 412);
    EXPECT_EQ(id_difference(image, image), IdDifference{});
    EXPECT_EQ(id_difference({}, {}), IdDifference{});
}

TEST(IdDifference, NamesAThingThatVanishedAndOneThatAppeared) {
    render::IdImage with = empty_picture(64, 64);
    fill(with, {10, 10, 40, 40}, 7);
    const render::IdImage without = with;
    fill(with, {20, 15, 24, 20}, 412);
    const PixelBox box{20, 15, 24, 20};
    EXPECT_EQ(id_difference(with, without),
              (IdDifference{20, box, {{412, 20, 0, 20, box}, {7, 880, 900, 20, box}}}));
    EXPECT_EQ(id_difference(without, with),
              (IdDifference{20, box, {{412, 0, 20, 20, box}, {7, 900, 880, 20, box}}}));
}

TEST(IdDifference, SeesAThingThatMovedAndKeptItsSize) {
    render::IdImage before = empty_picture(64, 64), after = before;
    fill(before, {10, 10, 20, 20}, 5);
    fill(after, {11, 10, 21, 20}, 5);
    EXPECT_EQ(id_difference(before, after),
              (IdDifference{20, {10, 10, 21, 20}, {{5, 100, 100, 20, {10, 10, 21, 20}}}}));
}

TEST(IdDifference, FindsOnePixel) {
    render::IdImage before = empty_picture(512, 512), after = before;
    fill(after, {511, 511, 512, 512}, 0xFFFFFFFF);
    const PixelBox box{511, 511, 512, 512};
    EXPECT_EQ(id_difference(before, after), (IdDifference{1, box, {{0xFFFFFFFF, 0, 1, 1, box}}}));
}

TEST(IdDifference, OrdersThingsByWhatHappenedThenByPixelsThenById) {
    render::IdImage before = empty_picture(100, 1), after = before;
    fill(before, {0, 0, 50, 1}, 3);
    fill(after, {0, 0, 20, 1}, 3);    // loses 30
    fill(before, {50, 0, 60, 1}, 9);  // vanishes
    fill(before, {60, 0, 70, 1}, 8);  // vanishes
    fill(after, {70, 0, 75, 1}, 2);   // appears
    fill(before, {80, 0, 90, 1}, 1);  // moves by 10
    fill(after, {90, 0, 100, 1}, 1);
    std::vector<std::uint32_t> ids;
    for (const IdChange& change : id_difference(before, after).changes) ids.push_back(change.id);
    EXPECT_EQ(ids, (std::vector<std::uint32_t>{8, 9, 2, 3, 1}));
}

TEST(IdDifference, AgreesWithANaiveRecount) {
    std::mt19937 random(4);
    for (int i = 0; i < 400; ++i) {
        const int width = 1 + static_cast<int>(random() % 40),
                  height = 1 + static_cast<int>(random() % 40);
        const auto random_box = [&] {
            const int left = static_cast<int>(random() % static_cast<unsigned>(width)),
                      top = static_cast<int>(random() % static_cast<unsigned>(height));
            return PixelBox{left, top, std::min(width, left + 1 + static_cast<int>(random() % 9)),
                            std::min(height, top + 1 + static_cast<int>(random() % 9))};
        };
        const std::uint32_t things = i % 2 ? 6 : 100000;
        render::IdImage before = empty_picture(width, height);
        for (int k = 0; k < 20; ++k)
            fill(before, random_box(), static_cast<std::uint32_t>(random() % things));
        render::IdImage after = before;
        for (int k = static_cast<int>(random() % 5); k > 0; --k)
            fill(after, random_box(), static_cast<std::uint32_t>(random() % things));
        if (i % 5 == 0)
            for (std::uint32_t& id : after.ids) id = static_cast<std::uint32_t>(random());
        ASSERT_EQ(id_difference(before, after), recount(before, after)) << i;
    }
}

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
    for (const int x : {1, 2, 4}) EXPECT_EQ(render::pixel(shown, x, 0), render::changed_color) << x;
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
