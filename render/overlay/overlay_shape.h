#pragma once

#include <string>
#include <variant>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// The shapes drawn on an overlay, for files with vector graphics. The position of a text is its
/// left end, for any alignment.
struct TextShape {
    int x = 0, y = 0, width = 0;
    std::string text;
    TextStyle style;
};
struct RectangleShape {
    PixelRect rect;
    Rgba8 color;
};
struct LineShape {
    std::vector<ScreenPosition> points;
    Rgba8 color;
    double thickness = 1;
    bool round = false;  ///< its ends and joints; a single point is a dot
};
struct PolygonShape {
    std::vector<ScreenPosition> corners;
    Rgba8 color;
};

using OverlayShape = std::variant<TextShape, RectangleShape, LineShape, PolygonShape>;

struct OverlayShapes {
    std::vector<OverlayShape> list;
};

}  // namespace scb::render
