#pragma once

#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// A convex polygon in a picture, corner by corner; may be empty.
using ScreenPolygon = std::vector<ScreenPosition>;

/// The points p of a picture with `normal.p <= limit`.
struct HalfPlane {
    ScreenPosition normal;
    double limit = 0;
};

struct ScreenCircle {
    ScreenPosition center;
    double radius = 0;  ///< pixels, of any number
};

ScreenPolygon polygon_of(const PixelRect& rect);

/// The part of a convex polygon in the half plane (Sutherland and Hodgman, "Reentrant Polygon
/// Clipping").
ScreenPolygon clipped(const ScreenPolygon& polygon, const HalfPlane& half_plane);

/// The part in a disc, to a tenth of a pixel within the rectangle that contains the polygon.
ScreenPolygon clipped(const ScreenPolygon& polygon, const ScreenCircle& disc,
                      const PixelRect& rect);

/// The parts of a line through the points that lie in the rectangle.
std::vector<std::vector<ScreenPosition>> clipped(const std::vector<ScreenPosition>& line,
                                                 const PixelRect& rect);

/// Points of a circle, close enough to draw its part in the rectangle: all around and back to the
/// first, or, if the rectangle is small relative to the circle, only the arc near it.
std::vector<ScreenPosition> circle_points(const ScreenCircle& circle, const PixelRect& rect);

}  // namespace scb::render
