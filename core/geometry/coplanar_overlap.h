#pragma once

#include <optional>

#include "scb/triangle_overlap.h"

namespace scb {

/// The axis along which the common plane of two coplanar triangles can be projected without losing
/// anything, if possible the steepest; none if all six corners are collinear.
std::optional<int> projection_axis(const TriangleCorners& a, const TriangleCorners& b);

/// Whether the line of an edge separates the triangles, projected along an axis that suits a. If
/// so, the triangles are apart, coplanar or not. This mostly decides nearly coplanar triangles
/// without an exact sum.
bool projections_apart(const TriangleCorners& a, const TriangleCorners& b);

/// triangles_overlap for triangles whose six corners are in one plane, degenerate ones included.
///
/// Convex polygons are disjoint if and only if the line of an edge of one separates them strictly
/// (their Minkowski difference is a polygon with edges parallel to theirs, and does not contain the
/// origin). A segment is a polygon with both its sides as edges; a point has no edge. If all
/// corners are collinear, the difference has no inside, and intervals are compared instead.
bool coplanar_overlap(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
