#pragma once

#include "scb/triangle_overlap.h"

namespace scb {

/// The distance of two triangles that do not intersect: the least of the distances of their edges
/// from each other, and of the corners of each from the other (Ericson, "Real-Time Collision
/// Detection", Section 5.1.10). Right but for rounding.
double triangle_gap(const TriangleCorners& a, const TriangleCorners& b);

/// How far one of two triangles that intersect must be moved, in whatever direction, until they do
/// no more: the least overlap of their extents along the normals of both planes and of each pair of
/// edges, which are those of the faces of their Minkowski difference. 0 of triangles in one plane.
/// Right but for rounding.
double triangle_depth(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
