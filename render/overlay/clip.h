#pragma once

#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// A convex polygon in a picture, corner by corner; empty where nothing is left.
using ScreenPolygon = std::vector<ScreenPosition>;

/// The points p of a picture with `normal.p <= limit`.
struct HalfPlane {
    ScreenPosition normal;
    double limit = 0;
};

struct ScreenCircle {
    ScreenPosition center;
    double radius = 0;  ///< pixels, however many
};

ScreenPolygon polygon_of(const PixelRect& rect);

/// What the half plane leaves of a convex polygon (Sutherland and Hodgman, "Reentrant Polygon
/// Clipping").
ScreenPolygon clipped(const ScreenPolygon& polygon, const HalfPlane& half_plane);

/// The same of a disc, to a tenth of a pixel within the rectangle that holds the polygon.
ScreenPolygon clipped(const ScreenPolygon& polygon, const ScreenCircle& disc,
                      const PixelRect& rect);

/// The parts of a line through the points that lie in the rectangle.
std::vector<std::vector<ScreenPosition>> clipped(const std::vector<ScreenPosition>& line,
                                                 const PixelRect& rect);

/// Points of a circle, close enough to draw what of it lies in the rectangle: all around and back
/// to the first, or only the arc near the rectangle where that is small beside the circle.
std::vector<ScreenPosition> circle_points(const ScreenCircle& circle, const PixelRect& rect);

}  // namespace scb::render
