#pragma once

#include <optional>

#include "scb/triangle_overlap.h"

namespace scb {

/// The axis along which the common plane of two coplanar triangles can be projected without losing
/// anything, if possible the steepest; none where all six corners are collinear.
std::optional<int> projection_axis(const TriangleCorners& a, const TriangleCorners& b);

/// Whether the line of an edge separates the triangles, projected along an axis that suits a: if
/// so, any two triangles are apart, and nearly coplanar ones are mostly found to be with no exact
/// sum.
bool projections_apart(const TriangleCorners& a, const TriangleCorners& b);

/// triangles_overlap for triangles whose six corners are in one plane, degenerate ones included.
///
/// Convex polygons are disjoint where, and only where, the line of an edge of one separates them
/// strictly from the other (their Minkowski difference is a polygon with edges parallel to theirs,
/// and does not contain the origin). A segment is a polygon with both its sides as edges, a point
/// has none; only where all corners are collinear does the difference have no inside, and
/// intervals are compared instead.
bool coplanar_overlap(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
