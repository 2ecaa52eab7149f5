#pragma once

#include <array>
#include <cstdint>

#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb {

/// The corners of a triangle, in any order. Where they are collinear or equal, the triangle is the
/// segment or the point that they span.
using TriangleCorners = std::array<Vec3, 3>;

/// The triangle's corners, in the body frame.
inline TriangleCorners corners(const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// The same seen from another frame.
inline TriangleCorners transform_corners(const Pose& pose, const TriangleCorners& t) {
    return {transform_point(pose, t[0]), transform_point(pose, t[1]), transform_point(pose, t[2])};
}

/// Whether two triangles, closed sets in one frame, have a point in common: touching is
/// overlapping, and degenerate triangles are the segments and points that they are. The answer is
/// exact for the given corners, any finite doubles, so it depends neither on the order of the
/// corners nor on the order of the triangles.
///
/// Corners of each against the plane of the other reject most pairs; then the two intervals in
/// which the triangles meet the line of both planes are compared, all by orientation predicates,
/// after Guigue and Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates" (2003). Coplanar triangles are separated by the line of an edge or overlap.
bool triangles_overlap(const TriangleCorners& a, const TriangleCorners& b);

/// How two triangles meet.
enum class TriangleContact : std::uint8_t {
    apart,     ///< no common point
    touching,  ///< common points, but none inside both triangles, or both are in one plane
    crossing,  ///< a common point inside both triangles, which are not in one plane
};

/// The same test, which also tells a crossing from a touch, exactly. It is `apart` where
/// triangles_overlap is false. The interior of a degenerate triangle is the interior of its
/// segment.
TriangleContact triangle_contact(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
