#pragma once

#include <cmath>

#include "core/geometry/exact_sum.h"
#include "scb/vec.h"

namespace scb {

// Signs of orientation determinants, exact for any finite doubles. A floating-point filter decides
// all but the nearly degenerate cases, ExactSum decides the rest. The filter is semi-static, as in
// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates"
// (the bound is proportional to the permanent); its derivation is in PlaneFilter. It holds whether
// or not the compiler contracts a * b + c to one rounding, but not where it may reassociate.
#ifdef __FAST_MATH__
#error "orientation.h needs IEEE arithmetic: do not compile with -ffast-math"
#endif

/// The plane through three points, and a test on which side of it other points certainly are.
///
/// With u = 2^-53, each of the six terms (b - a)_i (c - a)_j (d - a)_k of the determinant meets at
/// most 8 roundings: three of differences, two of products, one of the difference of two products,
/// two of the final sum. Hence |computed - exact| <= ((1 + u)^8 - 1) P, where P, the permanent, is
/// the sum of the terms' magnitudes. The computed P meets the same roundings, all to at least
/// (1 - u) times its value, so that 10 u times the computed P exceeds the bound.
///
/// Underflow adds at most 2^-1074 to each product. In a component of the normal, this error is
/// multiplied by the difference d - a. So is `underflow`, which is added to the component's
/// magnitude: 10 u 2^-960 = 2^-1009 and more. For the last products and the products of the bound
/// itself, `underflow` is added once more. If a term overflows, the bound also overflows, or one
/// side of the comparison is not a number: no sign is certain then.
struct PlaneFilter {
    static constexpr double relative_error = 10 * 0x1p-53;
    static constexpr double underflow = 0x1p-960;

    Vec3 origin;     ///< a
    Vec3 normal;     ///< (b - a) x (c - a)
    Vec3 magnitude;  ///< of the terms that make up each component of the normal

    PlaneFilter(const Vec3& a, const Vec3& b, const Vec3& c) : origin(a) {
        const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
        const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
        const double yz = by * cz, zy = bz * cy, zx = bz * cx, xz = bx * cz, xy = bx * cy,
                     yx = by * cx;
        normal = {yz - zy, zx - xz, xy - yx};
        magnitude = {std::abs(yz) + std::abs(zy) + underflow,
                     std::abs(zx) + std::abs(xz) + underflow,
                     std::abs(xy) + std::abs(yx) + underflow};
    }

    /// 1 or -1: d is on this side of the plane, as orient3d(a, b, c, d) would say. 0: not certain.
    int side(const Vec3& d) const {
        const double x = d[0] - origin[0], y = d[1] - origin[1], z = d[2] - origin[2];
        const double determinant = normal[0] * x + normal[1] * y + normal[2] * z;
        const double permanent =
            magnitude[0] * std::abs(x) + magnitude[1] * std::abs(y) + magnitude[2] * std::abs(z);
        const double bound = relative_error * permanent + underflow;
        return static_cast<int>(determinant > bound) - static_cast<int>(determinant < -bound);
    }
};

/// The sign of det(b - a, c - a, d - a): 1 where d is on the side of the plane that the normal
/// (b - a) x (c - a) points to, -1 on the other side, 0 where the four points are coplanar. The
/// points must be finite.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The sign of the component `axis` of (b - a) x (c - a): 1 where a, b, c, projected along that
/// axis, turn counterclockwise as seen from its tip, 0 where the projections are collinear. The
/// points must be finite.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// orient3d and orient2d without the filter, for callers that have applied it already.
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
int orient2d_exact(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// The determinants themselves, with a relative error of at most 2^-50, for ratios of heights that
/// stay meaningful if points are nearly coplanar.
ScaledDouble orient3d_value(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
ScaledDouble orient2d_value(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

}  // namespace scb
