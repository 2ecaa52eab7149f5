#include "golden/compare/id_picture.h"

#include <cassert>
#include <cstdint>
#include <vector>

namespace scb::golden {
namespace {

/// Consecutive ids are far apart in hue.
render::Rgba8 color_of(std::uint32_t id) {
    if (id == 0) return {0, 0, 0, 0};
    std::uint32_t h = id * 0x9e3779b1u;
    h ^= h >> 15;
    h *= 0x85ebca77u;
    h ^= h >> 13;
    const auto channel = [&](int shift) {
        return static_cast<std::uint8_t>(60 + ((h >> shift) & 0xff) * 165 / 255);
    };
    return {channel(0), channel(8), channel(16), 255};
}

}  // namespace

render::Image shown_ids(const render::IdImage& ids) {
    render::Image image{ids.width, ids.height, std::vector<std::uint8_t>(4 * ids.ids.size())};
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            render::set_pixel(image, x, y, color_of(render::pixel(ids, x, y)));
    return image;
}

render::Image shown_id_difference(const render::IdImage& before, const render::IdImage& after) {
    assert(before.width == after.width && before.height == after.height &&
           "id pictures of two sizes have no difference");
    render::Image image{after.width, after.height, std::vector<std::uint8_t>(4 * after.ids.size())};
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x) {
            const std::uint32_t id = render::pixel(after, x, y);
            const auto pale = static_cast<std::uint8_t>(id == 0 ? 250 : 205 + color_of(id).g / 8);
            render::set_pixel(image, x, y,
                              id == render::pixel(before, x, y) ? render::Rgba8{pale, pale, pale}
                                                                : render::Rgba8{213, 0, 70});
        }
    return image;
}

}  // namespace scb::golden
