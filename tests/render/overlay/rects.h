#pragma once

#include "render/overlay/figure_layout.h"

namespace scb::render {

/// Whether the two share no pixel.
inline bool apart(const PixelRect& a, const PixelRect& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
           b.y + b.height <= a.y;
}

}  // namespace scb::render
