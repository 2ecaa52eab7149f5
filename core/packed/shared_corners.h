#pragma once

#include "scb/triangle_distance.h"

namespace scb {

/// Whether u, exactly a corner of the triangle, is clearly the point of the triangle that is
/// farthest along v: other corners are behind it by 2^-10 of their distance or more. `scale`: the
/// largest coordinate; no edge at u, nor v, is a very small part of it. The angle at u is not
/// near 0 or half a turn.
bool is_farthest_corner(const TriangleCorners& t, const Vec3& u, const Vec3& v, double scale);

/// Whether triangle_distance of these triangles, which do not intersect, certainly is the distance
/// of the points of `nearest`, with the same bits: the points are corners of the triangles, and
/// each is clearly farthest towards the other.
///
/// For then any two other points x and y of the triangles, in exact arithmetic, have a larger
/// squared distance by 2^-9 |v| (|x - u| + |y - w|), where u and w are the corners and v = w - u.
/// Rounding hides that only if both are within some 2^-38 of the scale. A feature that has such a
/// point x beside u is an edge at u, or the face. triangle_distance does not take it: from a y
/// that near to w, the nearest point of the line is outside of the edge by 2^-10 |v|, and the foot
/// on the plane is beside u by as much.
bool is_distance_of_corners(const TriangleCorners& a, const TriangleCorners& b,
                            const TriangleDistance& nearest);

}  // namespace scb
