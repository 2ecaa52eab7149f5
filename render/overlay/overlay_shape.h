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

/// The picture as SVG 1.1: the shapes that an overlay has recorded, in its order, over `views`, an
/// image of the scene without them; nullptr: over the background alone. Letters are text in Roboto,
/// or in another sans-serif face, as wide as the overlay has measured them. The same picture always
/// gives the same bytes.
std::string svg_text(const OverlayShapes& shapes, const Picture& picture, const Image* views);

}  // namespace scb::render
