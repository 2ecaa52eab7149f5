#pragma once

#include <vector>

#include "scb/triangle_overlap.h"

namespace scb {

/// Whether all corners of each triangle are nearer to the plane of the larger one than a millionth
/// of the longest edge; false for degenerate triangles. Rounded, for drawing.
bool in_one_plane(const TriangleCorners& a, const TriangleCorners& b);

/// The common part of two triangles that lie on each other, for drawing: a convex polygon with 3 to
/// 6 corners in order, each in `a`. Empty if the triangles are not in_one_plane, or if the common
/// part is narrower than a millionth of the longest edge. Rounded, unlike triangles_overlap. The
/// polygon is `a` clipped by the edges of `b` (Sutherland and Hodgman, "Reentrant Polygon
/// Clipping", 1974).
std::vector<Vec3> common_area(const TriangleCorners& a, const TriangleCorners& b);

/// The normal of a convex polygon, as long as twice its area.
Vec3 area_normal(const std::vector<Vec3>& polygon);

}  // namespace scb
