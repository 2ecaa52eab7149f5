#include "scb/triangle_overlap.h"

#include "core/geometry/coplanar_overlap.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

bool any_zero(const Sides& s) { return s[0] == 0 || s[1] == 0 || s[2] == 0; }

// The intervals [i, j] of a and [k, l] of b on the line L: i <= l and k <= j.
bool crossing_overlap(const TriangleCorners& a, const TriangleCorners& b, const PairSides& sides) {
    const LinePoints on_a = line_points_of_a(sides.of_a), on_b = line_points_of_b(sides.of_b);
    return order_on_line(a, on_a, on_a.first, b, on_b, on_b.second) >= 0 &&
           order_on_line(a, on_a, on_a.second, b, on_b, on_b.first) <= 0;
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
    switch (arrange(a, b, sides)) {
        case Arrangement::apart:
            return false;
        case Arrangement::crossing:
            return crossing_overlap(a, b, sides);
        case Arrangement::segment_a: {
            const std::array<Vec3, 2> segment = ends(a);
            return segment_meets_triangle(segment[0], segment[1], b);
        }
        case Arrangement::segment_b: {
            const std::array<Vec3, 2> segment = ends(b);
            return segment_meets_triangle(segment[0], segment[1], a);
        }
        case Arrangement::one_plane:
            return coplanar_overlap(a, b);
    }
    return false;
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

}  // namespace scb
