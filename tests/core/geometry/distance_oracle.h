#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "scb/triangle_overlap.h"

// Distances of triangles in higher precision, slowly and without the formulas of the library.
namespace scb::distance_oracle {

using Real = long double;
using Point = std::array<Real, 3>;

inline Point operator-(const Point& p, const Point& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Point along(const Point& p, Real share, const Point& d) {
    return {p[0] + share * d[0], p[1] + share * d[1], p[2] + share * d[2]};
}
inline Real dot(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline Real length(const Point& p) { return std::sqrt(dot(p, p)); }

inline Real clamped(Real x) { return std::clamp(x, Real(0), Real(1)); }

inline Real share_of(const Point& p, const Point& s, const Point& d) {
    const Real dd = dot(d, d);
    return dd > 0 ? clamped(dot(p - s, d) / dd) : 0;
}

/// Of two segments, by alternating projections from many starts: slow, and without case analysis.
inline Real segments(const Point& p, const Point& q, const Point& s, const Point& t) {
    const Point u = q - p, v = t - s;
    Real least = length(p - s);
    for (const Real start : {0.0L, 0.25L, 0.5L, 0.75L, 1.0L}) {
        Real of_u = start;
        for (int k = 0; k < 40; ++k) {
            const Real of_v = share_of(along(p, of_u, u), s, v);
            least = std::min(least, length(along(p, of_u, u) - along(s, of_v, v)));
            of_u = share_of(along(s, of_v, v), p, u);
            least = std::min(least, length(along(p, of_u, u) - along(s, of_v, v)));
        }
    }
    // Where they nearly cross, projections converge slowly.
    const Real uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), determinant = uu * vv - uv * uv;
    if (determinant > 0) {
        const Point w = p - s;
        const Real of_u = clamped((uv * dot(v, w) - vv * dot(u, w)) / determinant);
        least = std::min(
            least, length(along(p, of_u, u) - along(s, share_of(along(p, of_u, u), s, v), v)));
    }
    return least;
}

/// Of a point and a triangle's plane where the point is above the inside; else infinity.
inline Real above(const Point& p, const std::array<Point, 3>& t) {
    Real least = HUGE_VALL;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = t[k], d1 = t[(k + 1) % 3] - a, d2 = t[(k + 2) % 3] - a;
        const Real d11 = dot(d1, d1), d12 = dot(d1, d2), d22 = dot(d2, d2),
                   determinant = d11 * d22 - d12 * d12;
        if (!(determinant > 0)) continue;
        const Point w = p - a;
        const Real x = (d22 * dot(w, d1) - d12 * dot(w, d2)) / determinant,
                   y = (d11 * dot(w, d2) - d12 * dot(w, d1)) / determinant;
        if (x >= 0 && y >= 0 && x + y <= 1)
            least = std::min(least, length(p - along(along(a, x, d1), y, d2)));
    }
    return least;
}

inline std::array<Point, 3> exact(const TriangleCorners& t) {
    std::array<Point, 3> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {t[i][0], t[i][1], t[i][2]};
    return result;
}

inline Real distance(const TriangleCorners& corners_a, const TriangleCorners& corners_b) {
    if (triangles_overlap(corners_a, corners_b)) return 0;
    const auto a = exact(corners_a), b = exact(corners_b);
    Real least = HUGE_VALL;
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, above(a[i], b), above(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j)
            least = std::min(least, segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
    return least;
}

}  // namespace scb::distance_oracle
