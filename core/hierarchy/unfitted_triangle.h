#pragma once

#include <algorithm>
#include <cmath>

#include "scb/scb.h"

namespace scb {

/// Stands for the SCB of a triangle that nothing but its surface area is asked of: a disc with at
/// most the area of any SCB that contains the triangle, and mostly nearly as much.
///
/// An SCB contains the disc about its center across its normal, of its whole radius, since its slab
/// contains the center; the disc's two sides have less area than its surface. Its radius is at
/// least that of the smallest ball of the triangle: half the longest side, or the radius of the
/// circumcircle where all angles are acute.
inline Scb unfitted_scb(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u = b - a, v = c - a;
    const double uu = squared_norm(u), vv = squared_norm(v), ww = squared_norm(c - b);
    const double longest = std::max({uu, vv, ww}), product = squared_norm(cross(u, v));
    double squared_radius = longest / 4;
    // Of a slender triangle the product may be little but rounding errors.
    if (uu + vv + ww > 2 * longest && product > 1e-3 * longest * longest)
        squared_radius = uu * vv / product * ww / 4;
    constexpr double rounding = 1 - 1e-9;
    return {a, std::sqrt(squared_radius) * rounding, Vec3::UnitX(), 0, 0};
}

}  // namespace scb
