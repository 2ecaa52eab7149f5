#pragma once

#include <utility>

#include "render/overlay/figure_layout.h"
#include "render/view/picture.h"

namespace scb::render {

inline Picture empty_picture(int width, int height) {
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.samples = 1;
    return picture;
}

inline bool contains(const PixelRect& rect, int x, int y) {
    return x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
}

/// Pixels that differ from the background, inside and outside a rectangle.
inline std::pair<int, int> inside_and_outside(const Image& image, const PixelRect& rect,
                                              Rgba8 background) {
    int inside = 0, outside = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (pixel(image, x, y) != background) ++(contains(rect, x, y) ? inside : outside);
    return {inside, outside};
}

/// Whether the two share no pixel.
inline bool apart(const PixelRect& a, const PixelRect& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
           b.y + b.height <= a.y;
}

}  // namespace scb::render
