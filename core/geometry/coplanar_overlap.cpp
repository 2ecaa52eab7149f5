#include "core/geometry/coplanar_overlap.h"

#include <cmath>

#include "core/geometry/orientation.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

// The axis to which the plane of the three points is closest to perpendicular, up to rounding.
int steepest_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = cross(b - a, c - a).cwiseAbs();
    return normal[0] > normal[1] ? (normal[0] > normal[2] ? 0 : 2)
                                 : (normal[1] > normal[2] ? 1 : 2);
}

// An axis along which the three points project to a proper triangle.
std::optional<int> axis_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const int steepest = steepest_axis(a, b, c);
    for (int i = 0; i < 3; ++i) {
        const int axis = (steepest + i) % 3;
        if (orient2d(a, b, c, axis) != 0) return axis;
    }
    return std::nullopt;
}

// Whether the line of an edge of a separates a, which may touch the line, from b strictly.
bool edge_separates(const TriangleCorners& a, const TriangleCorners& b, int axis) {
    const int turn = orient2d(a[0], a[1], a[2], axis);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &p = a[i], &q = a[(i + 1) % 3];
        const int side = orient2d(p, q, b[0], axis);
        if (side != 0 && side != turn && orient2d(p, q, b[1], axis) == side &&
            orient2d(p, q, b[2], axis) == side)
            return true;
    }
    return false;
}

}  // namespace

std::optional<int> projection_axis(const TriangleCorners& a, const TriangleCorners& b) {
    if (const auto axis = axis_of(a[0], a[1], a[2])) return axis;
    if (const auto axis = axis_of(b[0], b[1], b[2])) return axis;
    const std::array<Vec3, 2> end_a = ends(a), end_b = ends(b);
    if (const auto axis = axis_of(end_a[0], end_a[1], end_b[0])) return axis;
    if (const auto axis = axis_of(end_a[0], end_a[1], end_b[1])) return axis;
    return axis_of(end_b[0], end_b[1], end_a[0]);
}

bool projections_apart(const TriangleCorners& a, const TriangleCorners& b) {
    const int axis = steepest_axis(a[0], a[1], a[2]);
    return edge_separates(a, b, axis) || edge_separates(b, a, axis);
}

bool coplanar_overlap(const TriangleCorners& a, const TriangleCorners& b) {
    if (const std::optional<int> axis = projection_axis(a, b))
        return !edge_separates(a, b, *axis) && !edge_separates(b, a, *axis);
    const std::array<Vec3, 2> end_a = ends(a), end_b = ends(b);
    return !precedes(end_a[1], end_b[0]) && !precedes(end_b[1], end_a[0]);
}

}  // namespace scb
