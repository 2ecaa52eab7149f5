#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scb::render {

/// A color, 8 bits a channel, not premultiplied; `a` is 255 for opaque.
struct Rgba8 {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    bool operator==(const Rgba8&) const = default;
};

/// A picture: 4 bytes a pixel (r, g, b, a), row by row, the top row first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    bool operator==(const Image&) const = default;
};

/// The id that owns each pixel of a picture, laid out like the picture. 0 is the background.
struct IdImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> ids;

    bool operator==(const IdImage&) const = default;
};

/// The pixel in column x, counted from the left, and row y, counted from the top. Both must be
/// inside.
inline Rgba8 pixel(const Image& image, int x, int y) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

inline void set_pixel(Image& image, int x, int y, Rgba8 color) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x));
    image.rgba[at] = color.r;
    image.rgba[at + 1] = color.g;
    image.rgba[at + 2] = color.b;
    image.rgba[at + 3] = color.a;
}

inline std::uint32_t pixel(const IdImage& image, int x, int y) {
    return image.ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x)];
}

}  // namespace scb::render
