#pragma once

#include <optional>

#include "scb/triangle_overlap.h"

namespace scb {

/// A straight line from a to b; a point where they are equal.
struct LineSegment {
    Vec3 a;
    Vec3 b;
};

/// A segment in which two triangles meet, for drawing; it has a value exactly where
/// triangles_overlap holds.
///
/// Where the planes cross, it is the whole intersection. Which edges end it is decided exactly; its
/// ends are then rounded like any interpolation along these edges, also where the planes are
/// nearly the same (the heights to interpolate between are exact to 2^-50). Where the triangles
/// are coplanar, it is the longest piece of an edge of one that is inside the other, which is the
/// longest edge of the intersection. Segments and points (degenerate triangles) meet in what they
/// have in common. The ends are never NaN, and always in the bounding boxes of both triangles.
std::optional<LineSegment> triangles_intersection(const TriangleCorners& a,
                                                  const TriangleCorners& b);

}  // namespace scb
