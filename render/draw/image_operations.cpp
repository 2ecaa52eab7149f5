#include "render/draw/image_operations.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <iterator>
#include <new>
#include <tuple>

#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <stb_image_resize.h>
#pragma GCC diagnostic pop

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

namespace {

struct Shown {
    std::uint32_t id;
    Rgba8 color;

    auto key() const { return std::tuple(id, color.r, color.g, color.b, color.a); }
    bool operator<(const Shown& other) const { return key() < other.key(); }
};

std::vector<Shown> shown_in(const Pane& pane) {
    std::vector<Shown> shown;
    for (const VolumeInstance& volume : pane.volumes)
        if (volume.id != 0) shown.push_back({volume.id, volume.color});
    for (const MeshDraw& mesh : pane.meshes)
        if (mesh.first_id != 0 && mesh.chosen)
            for (const std::uint32_t t : *mesh.chosen)
                shown.push_back({mesh.first_id + t, mesh.triangle_colors.empty()
                                                        ? mesh.color
                                                        : mesh.triangle_colors[t]});
        else if (mesh.first_id != 0)
            for (std::uint32_t t = 0; t < mesh.triangle_colors.size(); ++t)
                shown.push_back({mesh.first_id + t, mesh.triangle_colors[t]});
    std::sort(shown.begin(), shown.end());
    return shown;
}

}  // namespace

std::vector<std::uint32_t> differing_ids(const Pane& a, const Pane& b) {
    const std::vector<Shown> in_a = shown_in(a), in_b = shown_in(b);
    std::vector<Shown> only_one;
    std::set_symmetric_difference(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(),
                                  std::back_inserter(only_one));
    std::vector<std::uint32_t> ids;
    for (const Shown& thing : only_one)
        if (ids.empty() || ids.back() != thing.id) ids.push_back(thing.id);
    return ids;
}

namespace {

// The position of alpha in a word depends on the machine.
constexpr auto opaque = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{0, 0, 0, 255});

/// The mean of four words byte by byte: two bytes at a time, so that no sum runs into the next.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t low = 0x00ff00ff, two = 0x00020002;
    const std::uint32_t even = (a & low) + (b & low) + (c & low) + (d & low) + two,
                        odd =
                            (a >> 8 & low) + (b >> 8 & low) + (c >> 8 & low) + (d >> 8 & low) + two;
    return (even >> 2 & low) | (odd >> 2 & low) << 8;
}

}  // namespace

void resolve_colors(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row) {
    assert(scale == 1 || scale == 2);
    if (scale == 1) {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = samples[x] | opaque;
        return;
    }
    const std::uint32_t* other = samples + 2 * row.size();
    for (std::size_t x = 0; x < row.size(); ++x)
        row[x] = mean(samples[2 * x], samples[2 * x + 1], other[2 * x], other[2 * x + 1]) | opaque;
}

void resolve_ids(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row) {
    const auto step = static_cast<std::size_t>(scale);
    const std::uint32_t* last = samples + (step - 1) * step * row.size();
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = last[step * x];
}

Image shrunk(const Image& picture, const PixelRect& part, int width, int height) {
    Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const std::size_t first =
        4 * (static_cast<std::size_t>(part.y) * static_cast<std::size_t>(picture.width) +
             static_cast<std::size_t>(part.x));
    if (!stbir_resize_uint8_generic(picture.rgba.data() + first, part.width, part.height,
                                    4 * picture.width, image.rgba.data(), width, height, 0, 4,
                                    STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_BOX,
                                    STBIR_COLORSPACE_LINEAR, nullptr))
        throw std::bad_alloc();
    return image;
}

}  // namespace scb::render
