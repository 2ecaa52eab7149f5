#pragma once

#include <optional>

#include "scb/triangle_overlap.h"

namespace scb {

/// A straight line from a to b; a point where they are equal.
struct LineSegment {
    Vec3 a;
    Vec3 b;
};

/// A segment in which two triangles meet, for drawing; it has a value if and only if
/// triangles_overlap.
///
/// Where the planes cross, it is the whole intersection. Exact tests decide which edges end it. Its
/// ends are then rounded like any interpolation along these edges, also if the planes are nearly
/// the same (the interpolated heights are exact to 2^-50). Where the triangles are coplanar, it is
/// the longest piece of an edge of one that is inside the other, which is the longest edge of the
/// intersection. For segments and points (degenerate triangles), it is their common part. The ends
/// are never NaN, and always in the bounding boxes of both triangles.
std::optional<LineSegment> triangles_intersection(const TriangleCorners& a,
                                                  const TriangleCorners& b);

/// The shortest translation after which two intersecting triangles do not intersect: the least
/// overlap of their extents along the normals of both planes and of each pair of edges. These are
/// the normals of the faces of their Minkowski difference. 0 for triangles in one plane. Exact up
/// to rounding.
double triangle_depth(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
