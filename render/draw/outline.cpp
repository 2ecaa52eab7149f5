#include "render/draw/outline.h"

#include <algorithm>

namespace scb::render {
namespace {

/// One byte for each pixel of a pane, row by row.
struct Mask {
    int width, height;
    std::vector<std::uint8_t> set;

    std::uint8_t& at(int x, int y) {
        return set[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
    }
};

Mask owned_pixels(const IdImage& image, const PixelRect& pane,
                  const std::vector<std::uint32_t>& ids) {
    Mask mask{pane.width, pane.height, {}};
    mask.set.reserve(static_cast<std::size_t>(pane.width) * static_cast<std::size_t>(pane.height));
    // Neighboring pixels often have the same owner.
    std::uint32_t last = 0;
    bool last_owned = false;
    for (int y = 0; y < pane.height; ++y)
        for (int x = 0; x < pane.width; ++x) {
            const std::uint32_t id = pixel(image, pane.x + x, pane.y + y);
            if (id != last) last_owned = std::binary_search(ids.begin(), ids.end(), id);
            last = id;
            mask.set.push_back(last_owned);
        }
    return mask;
}

}  // namespace

void draw_outline(Image& image, const IdImage& ids, const PixelRect& pane, const Outline& outline) {
    Mask mask = owned_pixels(ids, pane, outline.ids);
    const int width = outline.width, reach = width + std::max(1, width / 2);
    // Squared distance to the nearest owned pixel, up to the width of the outline.
    for (int y = 0; y < pane.height; ++y)
        for (int x = 0; x < pane.width; ++x) {
            if (mask.at(x, y)) continue;
            int nearest = reach * reach + 1;
            for (int v = std::max(0, y - reach); v <= std::min(pane.height - 1, y + reach); ++v)
                for (int u = std::max(0, x - reach); u <= std::min(pane.width - 1, x + reach); ++u)
                    if (mask.at(u, v))
                        nearest = std::min(nearest, (u - x) * (u - x) + (v - y) * (v - y));
            if (nearest <= reach * reach)
                set_pixel(image, pane.x + x, pane.y + y,
                          nearest <= width * width ? outline.color : outline.halo);
        }
}

}  // namespace scb::render
