#include "tests/core/distance/proven_triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scb {
namespace {

using precise::Point;
using precise::Real;
using precise::operator+;
using precise::operator-;
using precise::operator*;

using Corners = std::array<Point, 3>;

/// The least distance of two points that was found, and directions at right angles to features: the
/// first to those that the two points are inside of.
struct ClosestPoints {
    std::array<Point, 42> directions;
    std::size_t count = 0;
    Real squared = HUGE_VAL;

    void add(const Point& normal) { directions[count++] = normal; }
    void take(const Point& between, const Point& normal) {
        add(normal);
        const Real other = precise::dot(between, between);
        if (!(other < squared)) return;
        squared = other;
        std::swap(directions[0], directions[count - 1]);
    }
};

bool is_inside(const Real& share) { return Real(0) < share && share < Real(1); }

/// A corner and the inside of an edge. Twice, since the first difference cancels.
void take_edge(ClosestPoints& closest, const Point& corner, const Point& from, const Point& to) {
    const Point along = to - from;
    const Real squared = precise::dot(along, along);
    if (!(squared.high > 0)) return;
    const Real share = precise::dot(corner - from, along) / squared;
    if (!is_inside(share)) return;
    const Point rest = corner - from - share * along;
    const Point beside = rest - (precise::dot(rest, along) / squared) * along;
    closest.take(rest, beside);
}

/// A corner and the inside of a face.
void take_face(ClosestPoints& closest, const Point& corner, const Corners& t) {
    const Point u = t[1] - t[0], v = t[2] - t[0], w = corner - t[0], n = precise::cross(u, v);
    const Real squared = precise::dot(n, n);
    if (!(squared.high > 0)) return;
    const Real of_u = precise::dot(n, precise::cross(w, v)) / squared,
               of_v = precise::dot(n, precise::cross(u, w)) / squared;
    if (of_u < Real(0) || of_v < Real(0) || Real(1) < of_u + of_v) return closest.add(n);
    closest.take(w - of_u * u - of_v * v, n);
}

/// The insides of two edges.
void take_edges(ClosestPoints& closest, const Point& a0, const Point& a1, const Point& b0,
                const Point& b1) {
    const Point u = a1 - a0, v = b1 - b0, n = precise::cross(u, v);
    const Real squared = precise::dot(n, n);
    if (!(squared.high > 0)) return;
    const Real first = precise::dot(n, precise::cross(b0 - a0, v)) / squared;
    if (!is_inside(first)) return closest.add(n);
    const Real of_v = precise::dot(a0 + first * u - b0, v) / precise::dot(v, v);
    if (!is_inside(of_v)) return closest.add(n);
    const Point to_b = b0 + of_v * v - a0;
    const Real of_u = precise::dot(to_b, u) / precise::dot(u, u);
    if (!is_inside(of_u)) return closest.add(n);
    closest.take(to_b - of_u * u, n);
}

ClosestPoints closest_points(const Corners& a, const Corners& b) {
    ClosestPoints closest;
    for (std::size_t i = 0; i < 3; ++i) {
        take_face(closest, a[i], b);
        take_face(closest, b[i], a);
        for (std::size_t j = 0; j < 3; ++j) {
            const Point &a1 = a[(i + 1) % 3], &b1 = b[(j + 1) % 3];
            closest.take(b[j] - a[i], b[j] - a[i]);
            take_edge(closest, a[i], b[j], b1);
            take_edge(closest, b[j], a[i], a1);
            take_edges(closest, a[i], a1, b[j], b1);
        }
    }
    return closest;
}

/// How far apart the extents along a direction are; below 0 if they overlap.
Real gap_along(const Point& direction, const Corners& a, const Corners& b) {
    const Real length = precise::length(direction);
    if (!(length.high > 0)) return 0.0;
    const auto ends = [&](const Corners& t) {
        const auto at = [&](const Point& p) { return precise::dot(direction, p - a[0]); };
        const Real x = at(t[0]), y = at(t[1]), z = at(t[2]);
        return std::array<Real, 2>{precise::least(x, precise::least(y, z)),
                                   precise::most(x, precise::most(y, z))};
    };
    const auto of_a = ends(a), of_b = ends(b);
    return precise::most(of_b[0] - of_a[1], of_a[0] - of_b[1]) / length;
}

Corners precise_corners(const TriangleCorners& t) {
    return {precise::point(t[0]), precise::point(t[1]), precise::point(t[2])};
}

}  // namespace

ProvenTriangleDistance proven_triangle_distance(const TriangleCorners& a,
                                                const TriangleCorners& b) {
    if (triangles_overlap(a, b)) return {};
    const Corners of_a = precise_corners(a), of_b = precise_corners(b);
    const ClosestPoints closest = closest_points(of_a, of_b);
    const Real upper = precise::root(closest.squared);
    // Where points are the corner of one feature and inside of another one, up to rounding, another
    // direction may be better.
    Real lower = 0;
    for (std::size_t i = 0; i < closest.count && lower < upper - 0x1p-80 * upper; ++i)
        lower = precise::most(lower, gap_along(closest.directions[i], of_a, of_b));
    return {lower, upper};
}

}  // namespace scb
