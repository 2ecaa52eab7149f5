#pragma once

#include "scb/triangle_overlap.h"

namespace scb {

/// The distance of two triangles that do not intersect: the least of the distances of their edges
/// from each other, and of the corners of each from the other (Ericson, "Real-Time Collision
/// Detection", Section 5.1.10). Exact up to rounding.
double triangle_gap(const TriangleCorners& a, const TriangleCorners& b);

/// The shortest translation after which two intersecting triangles do not intersect: the least
/// overlap of their extents along the normals of both planes and of each pair of edges. These are
/// the normals of the faces of their Minkowski difference. 0 for triangles in one plane. Exact up
/// to rounding.
double triangle_depth(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
