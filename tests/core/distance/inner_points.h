#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "scb/packed_scb.h"
#include "scb/packed_scb2.h"
#include "scb/volume.h"
#include "tests/core/distance/precise_point.h"

// A point of a volume in double-double arithmetic, from a point that is in it up to rounding. The
// volume is the set of points that its numbers define, without rounding. So the distance of two
// such points is an upper bound of the distance of two volumes.
namespace scb::precise {

/// Toward `middle` until it is within the radius.
inline Point within_ball(const Point& p, const Point& middle, double radius) {
    const Point way = p - middle;
    const Real far = length(way);
    return Real(radius) < far ? middle + (Real(radius) / far) * way : p;
}

/// A center, and points about it: sums of vectors times shares from -1 to 1.
inline Point within_box(const Point& p, const Vec3& center, std::span<const Vec3> half_sides) {
    const Point rest = p - point(center);
    Point inside = point(center);
    for (const Vec3& side : half_sides) {
        const Point s = point(side);
        const Real squared = dot(s, s);
        if (squared.high > 0) inside = inside + clamped(dot(s, rest) / squared, -1.0, 1.0) * s;
    }
    return inside;
}

inline Point inner_point(const Ball& ball, const Vec3& p) {
    return within_ball(point(p), point(ball.center), ball.radius);
}
template <bool exact>
Point inner_point(const BasicAabb<exact>& box, const Vec3& p) {
    Point inside = point(p);
    for (int k = 0; k < 3; ++k) {
        Real& x = inside[static_cast<std::size_t>(k)];
        x = clamped(x, Real(box.center[k]) - box.half[k], Real(box.center[k]) + box.half[k]);
    }
    return inside;
}
inline Point inner_point(const Obb& box, const Vec3& p) {
    const Point rest = point(p) - point(box.center);
    Point inside = point(box.center);
    for (int k = 0; k < 3; ++k) {
        const Point axis = point(box.axes.col(k));
        inside =
            inside + clamped(dot(axis, rest) / dot(axis, axis), -box.half[k], box.half[k]) * axis;
    }
    return inside;
}
inline Point inner_point(const Rss& v, const Vec3& p) {
    return within_ball(point(p), within_box(point(p), v.center, v.half_sides), v.radius);
}
inline Point inner_point(const Capsule& v, const Vec3& p) {
    return within_ball(point(p), within_box(point(p), v.center, {&v.half_axis, 1}), v.radius);
}

/// By projections on the planes that the point is beyond. The angles of the planes are large, so
/// these converge.
template <int k>
Point inner_point(const KDop<k>& v, const Vec3& p) {
    Point inside = point(p);
    for (int round = 0; round < 200; ++round) {
        bool moved = false;
        for (std::size_t i = 0; i < v.which.size(); ++i) {
            const auto& d = dop_directions[static_cast<std::size_t>(v.which[i])];
            const Point direction = point(Vec3(d[0], d[1], d[2]));
            const Real height = dot(direction, inside),
                       beyond = height - clamped(height, v.lower[i], v.upper[i]);
            if (std::abs(beyond.high) <= 0x1p-90 * (1 + std::abs(height.high))) continue;
            inside = inside - (beyond / dot(direction, direction)) * direction;
            moved = true;
        }
        if (!moved) break;
    }
    return inside;
}

/// A ball that is cut by one slab or two: lower <= normal.(x - center) <= upper.
template <std::size_t slabs>
struct CutBall {
    Vec3 center;
    double radius;
    std::array<Vec3, slabs> normals;
    std::array<Real, slabs> lower, upper;
};
inline CutBall<1> cut_ball(const Scb& v) { return {v.c, v.r, {v.n}, {v.f}, {v.e}}; }
inline CutBall<2> cut_ball(const Scb2& v) {
    const auto& [first, second] = v.slabs;
    return {v.c, v.r, {first.n, second.n}, {first.f, second.f}, {first.e, second.e}};
}
inline CutBall<1> cut_ball(const PackedScb& v) {
    const Real m = static_cast<double>(v.m), h = static_cast<double>(v.h);
    return {center(v),
            static_cast<double>(v.r),
            {Vec3(static_cast<double>(v.n[0]), static_cast<double>(v.n[1]),
                  static_cast<double>(v.n[2]))},
            {m - h},
            {m + h}};
}
inline CutBall<2> cut_ball(const PackedScb2& v) {
    CutBall<2> ball{center(v), static_cast<double>(v.r), normals(v), {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const Real m = static_cast<double>(v.m[i]), h = static_cast<double>(v.h[i]);
        ball.lower[i] = m - h;
        ball.upper[i] = m + h;
    }
    return ball;
}

/// The vectors that have the height 1 along one normal and 0 along the others.
inline std::array<Point, 1> dual(const std::array<Vec3, 1>& normals) {
    const Point n = point(normals[0]);
    return {(Real(1) / dot(n, n)) * n};
}
inline std::array<Point, 2> dual(const std::array<Vec3, 2>& normals) {
    const Point n = point(normals[0]), m = point(normals[1]);
    const Real nn = dot(n, n), nm = dot(n, m), mm = dot(m, m),
               inverse = Real(1) / (nn * mm - nm * nm);
    return {inverse * (mm * n - nm * m), inverse * (nn * m - nm * n)};
}

/// First toward the center, then the heights, then what is beside the normals.
template <class V>
requires requires(const V& v) { cut_ball(v); }
Point inner_point(const V& v, const Vec3& p) {
    const auto ball = cut_ball(v);
    const auto along = dual(ball.normals);
    const Point rest = within_ball(point(p), point(ball.center), ball.radius) - point(ball.center);
    const Real radius = ball.radius;
    Point beside = rest, at{}, nearest{};  // of the points of the slabs, the nearest to the center
    for (std::size_t i = 0; i < along.size(); ++i) {
        const Real height = dot(point(ball.normals[i]), rest);
        beside = beside - height * along[i];
        at = at + clamped(height, ball.lower[i], ball.upper[i]) * along[i];
        nearest = nearest + clamped(0.0, ball.lower[i], ball.upper[i]) * along[i];
    }
    if (radius < length(at)) {
        const Point way = at - nearest;
        const Real a = dot(way, way), b = dot(way, nearest),
                   c = dot(nearest, nearest) - radius * radius;
        at = nearest + (a.high > 0 ? (root(b * b - a * c) - b) / a : Real(0)) * way;
    }
    const Real room = root(radius * radius - dot(at, at)), far = length(beside);
    if (room < far) beside = (room / far) * beside;
    return point(ball.center) + at + beside;
}

}  // namespace scb::precise
