#pragma once

#include <array>
#include <cmath>

#include "core/base/double_double.h"
#include "scb/pose.h"

// Points in double-double arithmetic, for oracles. Results are off by some 2^-98 of the numbers.
namespace scb::precise {

using Real = DoubleDouble;
using Point = std::array<Real, 3>;

inline Point point(const Vec3& p) { return {p[0], p[1], p[2]}; }
inline Vec3 rounded(const Point& p) { return {p[0].high, p[1].high, p[2].high}; }

inline Point operator+(const Point& p, const Point& q) {
    return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Point operator-(const Point& p, const Point& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Point operator*(const Real& share, const Point& p) {
    return {share * p[0], share * p[1], share * p[2]};
}
inline Real dot(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline Point cross(const Point& p, const Point& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Real least(const Real& x, const Real& y) { return y < x ? y : x; }
inline Real most(const Real& x, const Real& y) { return x < y ? y : x; }
inline Real clamped(const Real& x, const Real& lower, const Real& upper) {
    return least(most(x, lower), upper);
}

/// 0 for numbers below 0. One step of Newton from the root in doubles.
inline Real root(const Real& x) {
    if (!(x.high > 0)) return 0;
    const Real first = std::sqrt(x.high);
    return first + (x - first * first) / (first + first);
}
inline Real length(const Point& p) { return root(dot(p, p)); }

/// The image of a point, for the numbers of the pose as they are.
inline Point placed(const Pose& pose, const Point& p) {
    Point image = point(pose.translation);
    for (int k = 0; k < 3; ++k)
        image = image + p[static_cast<std::size_t>(k)] * point(Vec3(pose.rotation.col(k)));
    return image;
}

}  // namespace scb::precise
