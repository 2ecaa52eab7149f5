#include "core/geometry/triangle_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/coplanar_overlap.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

// h / (h - k), for h and k of opposite sign or one of them zero: the position of zero between h and
// k.
double zero_between(const ScaledDouble& h, const ScaledDouble& k) {
    if (h.significand == 0) return 0;
    if (k.significand == 0) return 1;
    const int apart = std::clamp(k.exponent - h.exponent, -2000, 2000);
    return 1 / (1 + std::abs(std::ldexp(k.significand / h.significand, apart)));
}

// p + t (q - p), without overflow, between p and q.
Vec3 between(const Vec3& p, const Vec3& q, double t) {
    return ((1 - t) * p + t * q).cwiseMax(p.cwiseMin(q)).cwiseMin(p.cwiseMax(q));
}

Vec3 clamp_to_box(const Vec3& p, const TriangleCorners& t) {
    return p.cwiseMax(t[0].cwiseMin(t[1]).cwiseMin(t[2]))
        .cwiseMin(t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

// The point in which pq meets the plane of t; its ends must not be strictly on one side of that
// plane.
Vec3 meeting_point(const Vec3& p, const Vec3& q, const TriangleCorners& t) {
    const double at =
        zero_between(orient3d_value(t[0], t[1], t[2], p), orient3d_value(t[0], t[1], t[2], q));
    return clamp_to_box(between(p, q, at), t);
}

LineSegment crossing_segment(const TriangleCorners& a, const TriangleCorners& b,
                             const PairSides& sides) {
    const LinePoints on_a = line_points_of_a(sides.of_a), on_b = line_points_of_b(sides.of_b);
    const auto later_end = [&](std::uint8_t to_a, std::uint8_t to_b, int sign) {
        return order_on_line(a, on_a, to_a, b, on_b, to_b) * sign > 0
                   ? meeting_point(b[on_b.apex], b[to_b], a)
                   : meeting_point(a[on_a.apex], a[to_a], b);
    };
    return {later_end(on_a.first, on_b.first, 1), later_end(on_a.second, on_b.second, -1)};
}

// The piece of a segment between two fractions of its length.
struct Piece {
    Vec3 p, q;
    double from = 0, to = 1;
    double length = -std::numeric_limits<double>::infinity();
};

// The part of pq in the proper triangle t, both projected along an axis; its length is minus
// infinity if there is none.
Piece clipped(const Vec3& p, const Vec3& q, const TriangleCorners& t, int axis) {
    const int turn = orient2d(t[0], t[1], t[2], axis);
    Piece piece{p, q};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &u = t[i], &v = t[(i + 1) % 3];
        const int inside_p = turn * orient2d(u, v, p, axis),
                  inside_q = turn * orient2d(u, v, q, axis);
        if (inside_p < 0 && inside_q < 0) return piece;
        if (inside_p >= 0 && inside_q >= 0) continue;
        const double at =
            zero_between(orient2d_value(u, v, p, axis), orient2d_value(u, v, q, axis));
        if (inside_p < 0)
            piece.from = std::max(piece.from, at);
        else
            piece.to = std::min(piece.to, at);
    }
    // Half of each, as the difference of two large coordinates may overflow.
    piece.length = (piece.to - piece.from) * (q / 2 - p / 2).stableNorm();
    return piece;
}

// For overlapping triangles in one plane; at least one must be proper.
LineSegment coplanar_segment(const TriangleCorners& a, const TriangleCorners& b, int axis) {
    std::optional<Piece> longest;
    const auto clip_edges = [&](const TriangleCorners& edges, const TriangleCorners& t) {
        if (orient2d(t[0], t[1], t[2], axis) == 0) return;
        for (std::size_t i = 0; i < 3; ++i) {
            const Piece piece = clipped(edges[i], edges[(i + 1) % 3], t, axis);
            if (!longest || piece.length > longest->length) longest = piece;
        }
    };
    clip_edges(a, b);
    clip_edges(b, a);
    // If triangles only touch, rounding may exchange the ends of the piece.
    if (longest->to < longest->from)
        longest->from = longest->to = (longest->from + longest->to) / 2;
    const auto end = [&](double at) {
        return clamp_to_box(clamp_to_box(between(longest->p, longest->q, at), a), b);
    };
    return {end(longest->from), end(longest->to)};
}

// For two segments or points in one plane that overlap.
LineSegment degenerate_segment(const TriangleCorners& a, const TriangleCorners& b,
                               std::optional<int> axis) {
    const std::array<Vec3, 2> end_a = ends(a), end_b = ends(b);
    if (!axis)
        return {precedes(end_a[0], end_b[0]) ? end_b[0] : end_a[0],
                precedes(end_a[1], end_b[1]) ? end_a[1] : end_b[1]};
    const double at = zero_between(orient2d_value(end_b[0], end_b[1], end_a[0], *axis),
                                   orient2d_value(end_b[0], end_b[1], end_a[1], *axis));
    const Vec3 point = clamp_to_box(between(end_a[0], end_a[1], at), b);
    return {point, point};
}

}  // namespace

std::optional<LineSegment> triangles_intersection(const TriangleCorners& a,
                                                  const TriangleCorners& b) {
    if (!triangles_overlap(a, b)) return std::nullopt;
    PairSides sides{};
    switch (arrange(a, b, sides)) {
        case Arrangement::apart:
            return std::nullopt;
        case Arrangement::crossing:
            return crossing_segment(a, b, sides);
        case Arrangement::segment_a: {
            const std::array<Vec3, 2> segment = ends(a);
            const Vec3 point = meeting_point(segment[0], segment[1], b);
            return LineSegment{point, point};
        }
        case Arrangement::segment_b: {
            const std::array<Vec3, 2> segment = ends(b);
            const Vec3 point = meeting_point(segment[0], segment[1], a);
            return LineSegment{point, point};
        }
        case Arrangement::one_plane:
            break;
    }
    const std::optional<int> axis = projection_axis(a, b);
    if (is_degenerate(a) && is_degenerate(b)) return degenerate_segment(a, b, axis);
    return coplanar_segment(a, b, *axis);
}

}  // namespace scb
