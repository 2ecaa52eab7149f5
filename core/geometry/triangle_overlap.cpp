#include "scb/triangle_overlap.h"

#include <algorithm>

#include "core/geometry/coplanar_overlap.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

bool any_zero(const Sides& s) { return s[0] == 0 || s[1] == 0 || s[2] == 0; }

bool has_both_sides(const Sides& s) {
    const auto [least, greatest] = std::minmax({s[0], s[1], s[2]});
    return least < 0 && greatest > 0;
}

// The intervals [i, j] of a and [k, l] of b on the line L have a common point if i <= l and k <= j.
// If both triangles have corners on both sides of the other's plane, the inner points of these
// intervals are inner points of the triangles.
TriangleContact contact_on_line(const TriangleCorners& a, const TriangleCorners& b,
                                const PairSides& sides) {
    const LinePoints on_a = line_points_of_a(sides.of_a), on_b = line_points_of_b(sides.of_b);
    const int i_to_l = order_on_line(a, on_a, on_a.first, b, on_b, on_b.second);
    if (i_to_l < 0) return TriangleContact::apart;
    const int j_to_k = order_on_line(a, on_a, on_a.second, b, on_b, on_b.first);
    if (j_to_k > 0) return TriangleContact::apart;
    return i_to_l > 0 && j_to_k < 0 && has_both_sides(sides.of_a) && has_both_sides(sides.of_b)
               ? TriangleContact::crossing
               : TriangleContact::touching;
}

bool crossing_overlap(const TriangleCorners& a, const TriangleCorners& b, const PairSides& sides) {
    return contact_on_line(a, b, sides) != TriangleContact::apart;
}

// Of a segment, given as a triangle, and a proper triangle whose plane it meets in one point.
TriangleContact segment_contact(const TriangleCorners& segment, const TriangleCorners& t) {
    const auto [p, q] = ends(segment);
    if (!segment_meets_triangle(p, q, t)) return TriangleContact::apart;
    bool inside = orient3d(t[0], t[1], t[2], p) * orient3d(t[0], t[1], t[2], q) < 0;
    for (std::size_t i = 0; i < 3 && inside; ++i)
        inside = orient3d(p, q, t[i], t[(i + 1) % 3]) != 0;
    return inside ? TriangleContact::crossing : TriangleContact::touching;
}

// `sides`: of a filter, see arrange.
TriangleContact contact_of(const TriangleCorners& a, const TriangleCorners& b, PairSides sides) {
    switch (arrange(a, b, sides)) {
        case Arrangement::apart:
            break;
        case Arrangement::crossing:
            return contact_on_line(a, b, sides);
        case Arrangement::segment_a:
            return segment_contact(a, b);
        case Arrangement::segment_b:
            return segment_contact(b, a);
        case Arrangement::one_plane:
            return coplanar_overlap(a, b) ? TriangleContact::touching : TriangleContact::apart;
    }
    return TriangleContact::apart;
}

bool share_corner(const TriangleCorners& a, const TriangleCorners& b) {
    for (const Vec3& p : a)
        for (const Vec3& q : b)
            if (p == q) return true;
    return false;
}

// Out of line, so that rare cases do not slow down the others.
[[gnu::noinline]] bool uncertain_overlap(const TriangleCorners& a, const TriangleCorners& b,
                                         PairSides sides) {
    if (share_corner(a, b)) return true;  // neighbors in a mesh
    if (projections_apart(a, b)) return false;
    return contact_of(a, b, sides) != TriangleContact::apart;
}

}  // namespace

bool triangles_overlap(const TriangleCorners& a, const TriangleCorners& b) {
    PairSides sides;
    const PlaneFilter plane_a(a[0], a[1], a[2]);
    sides.of_b = {plane_a.side(b[0]), plane_a.side(b[1]), plane_a.side(b[2])};
    if (strictly_on_one_side(sides.of_b)) return false;
    const PlaneFilter plane_b(b[0], b[1], b[2]);
    sides.of_a = {plane_b.side(a[0]), plane_b.side(a[1]), plane_b.side(a[2])};
    if (strictly_on_one_side(sides.of_a)) return false;
    if (any_zero(sides.of_a) || any_zero(sides.of_b)) return uncertain_overlap(a, b, sides);
    return crossing_overlap(a, b, sides);
}

TriangleContact triangle_contact(const TriangleCorners& a, const TriangleCorners& b) {
    PairSides sides;
    const PlaneFilter plane_a(a[0], a[1], a[2]), plane_b(b[0], b[1], b[2]);
    sides.of_b = {plane_a.side(b[0]), plane_a.side(b[1]), plane_a.side(b[2])};
    sides.of_a = {plane_b.side(a[0]), plane_b.side(a[1]), plane_b.side(a[2])};
    return contact_of(a, b, sides);
}

}  // namespace scb
