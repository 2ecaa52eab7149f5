#pragma once

#include <algorithm>
#include <cmath>

#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

// Stand-ins for the volumes of triangles, of use only for their visit_cost: at most the cost of any
// volume of the type that contains the triangle, and mostly nearly as much.

/// The triangle's area, and a lower bound of the radius of balls about it: the radius of the
/// smallest ball, which is half the longest side, or the radius of the circumcircle if all angles
/// are acute. Both are smaller for slender triangles, and because of rounding.
struct TriangleSize {
    double area, radius;

    TriangleSize(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 u = b - a, v = c - a;
        const double uu = squared_norm(u), vv = squared_norm(v), ww = squared_norm(c - b);
        const double longest = std::max({uu, vv, ww}), product = squared_norm(cross(u, v));
        double squared_radius = longest / 4;
        // For a slender triangle, the product may be mostly rounding errors.
        const bool slender = !(product > 1e-3 * longest * longest);
        if (uu + vv + ww > 2 * longest && !slender) squared_radius = uu * vv / product * ww / 4;
        constexpr double rounding = 1 - 1e-9;
        radius = std::sqrt(squared_radius) * rounding;
        area = slender ? 0 : std::sqrt(product) / 2 * rounding;
    }
};

/// A disc. An SCB contains the disc about its center, across its normal and with its radius, since
/// its slab contains the center. The disc's two sides have less area than the SCB's surface.
inline void set_unfitted(Scb& scb, const Vec3& a, const Vec3& b, const Vec3& c) {
    scb = {a, TriangleSize(a, b, c).radius, Vec3::UnitX(), 0, 0};
}

/// A strip. The widths of the slabs, w and v, and the length 2 r along them bound the triangle's
/// shadows along the axes: a triangle fills at most half of a rectangle, so its squared area is at
/// most (w^2 v^2 + 4 r^2 (w^2 + v^2)) / 4, which is less than r^2 (w + v)^2. And 2 r + area / r
/// grows with r, from the radius of the smallest ball on.
inline void set_unfitted(Scb2& scb, const Vec3& a, const Vec3& b, const Vec3& c) {
    const TriangleSize size(a, b, c);
    scb = {};
    scb.c = a;
    scb.r = size.radius;
    if (size.radius > 0) scb.slabs[0].e = size.area / size.radius;
}

}  // namespace scb
