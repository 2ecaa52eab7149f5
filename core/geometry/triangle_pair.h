#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "scb/mesh.h"
#include "scb/triangle_overlap.h"

namespace scb {

// The arrangement of two triangles, for triangles_overlap and triangles_intersection.

/// The sides of the plane of one triangle on which the corners of another are: 1, -1, or 0 in it.
/// All are 0 if the triangle of the plane is degenerate.
using Sides = std::array<int, 3>;

inline bool strictly_on_one_side(const Sides& s) {
    return s[0] != 0 && s[0] == s[1] && s[0] == s[2];
}

/// The sides of the corners of each triangle against the plane of the other.
struct PairSides {
    Sides of_a;
    Sides of_b;
};

enum class Arrangement : std::uint8_t {
    apart,      ///< no common point: a plane separates them, or a degenerate pair does not meet
    crossing,   ///< two proper triangles, in planes that cross in a line
    segment_a,  ///< a is a segment that meets the plane of b, a proper triangle, in one point
    segment_b,  ///< the same with a and b exchanged
    one_plane,  ///< all corners in one plane, some or all triangles perhaps degenerate
};

/// Completes sides that a filter left uncertain, written as 0, and returns the arrangement. If the
/// result is `apart` or `one_plane`, the sides may stay incomplete.
Arrangement arrange(const TriangleCorners& a, const TriangleCorners& b, PairSides& sides);

/// Whether the corners are collinear.
bool is_degenerate(const TriangleCorners& t);

/// Lexicographic order. Along a line, it is one of the line's two directions.
inline bool precedes(const Vec3& p, const Vec3& q) {
    if (p[0] != q[0]) return p[0] < q[0];
    if (p[1] != q[1]) return p[1] < q[1];
    return p[2] < q[2];
}

/// The first and the last corner in lexicographic order: the ends of a degenerate triangle.
std::array<Vec3, 2> ends(const TriangleCorners& t);

/// Whether the segment pq meets the proper triangle t; p and q must not be strictly on one side of
/// its plane, nor both in it.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TriangleCorners& t);

/// The two edges of a triangle that meet the line L in which its plane and the other's cross: the
/// edges from the corner `apex`, which is alone on its side, to `first` and `second`. Each meets L
/// in one point. Along L, the point of `first` comes first, or both are at one place.
struct LinePoints {
    std::uint8_t apex, first, second;
    std::int8_t side;  ///< of the apex; if it is in the plane, opposite to the other corners
};

/// For the first and for the second triangle of a pair that is `crossing`; L is directed as
/// n_a x n_b, with the normals of the triangles.
LinePoints line_points_of_a(const Sides& of_a);
LinePoints line_points_of_b(const Sides& of_b);

/// The sign of y - x along L. x is the point of L on the edge of a from its apex to corner `to_a`,
/// and y the point on the edge of b from its apex to corner `to_b`.
int order_on_line(const TriangleCorners& a, const LinePoints& on_a, std::uint8_t to_a,
                  const TriangleCorners& b, const LinePoints& on_b, std::uint8_t to_b);

/// Whether two triangles have a vertex in common. `joined`: the joined_vertices of the mesh, or of
/// the same mesh at rest.
inline bool share_vertex(const Mesh& mesh, std::span<const std::uint32_t> joined, std::uint32_t i,
                         std::uint32_t j) {
    for (const std::uint32_t a : mesh.triangles[i])
        for (const std::uint32_t b : mesh.triangles[j])
            if (joined[a] == joined[b]) return true;
    return false;
}

}  // namespace scb
