#pragma once

#include <array>

#include "scb/vec.h"

namespace scb {

/// The corners of a triangle, in any order. Where they are collinear or equal, the triangle is the
/// segment or the point that they span.
using TriangleCorners = std::array<Vec3, 3>;

/// Whether two triangles, closed sets in one frame, have a point in common: touching is
/// overlapping, and degenerate triangles are the segments and points that they are. The answer is
/// exact on the corners given, whatever finite doubles these are, so that it depends neither on
/// the order of the corners nor on that of the triangles.
///
/// Corners of each against the plane of the other reject most pairs; then the two intervals in
/// which the triangles meet the line of both planes are compared, all by orientation predicates,
/// after Guigue and Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates" (2003). Coplanar triangles are separated by the line of an edge or overlap.
bool triangles_overlap(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
