#include "scb/scb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scb {

double surface_area(const Scb& s) {
    return std::numbers::pi * (2 * s.r * (s.e - s.f) + 2 * s.r * s.r - s.e * s.e - s.f * s.f);
}

double volume(const Scb& s) {
    return std::numbers::pi / 3 *
           (s.e * (3 * s.r * s.r - s.e * s.e) - s.f * (3 * s.r * s.r - s.f * s.f));
}

bool contains(const Scb& s, const Vec3& point) {
    const Vec3 q = point - s.c;
    const double h = dot(s.n, q);
    return squared_norm(q) <= s.r * s.r && s.f <= h && h <= s.e;
}

bool is_well_formed(const Scb& s) {
    // A larger error would reach the bound on 1 - cosine^2 of two normals, see placement.
    constexpr double unit_error = 0x1p-49;
    return s.c.allFinite() && std::isfinite(s.r) && std::abs(squared_norm(s.n) - 1) <= unit_error &&
           -s.r <= s.f && s.f <= s.e && s.e <= s.r;
}

double support(const Scb& s, const Vec3& direction) {
    const double cosine = dot(s.n, direction);
    const double h = s.r * cosine;
    if (s.f <= h && h <= s.e) return s.r;
    // The plane cuts off the farthest point of the ball: the farthest point is on the rim of the
    // cut.
    const double k = h > s.e ? s.e : s.f;
    // |n x d|^2, since 1 - (n.d)^2 cancels if the two are nearly parallel.
    const double squared_sine = squared_norm(cross(s.n, direction));
    return k * cosine + std::sqrt(std::max(0.0, s.r * s.r - k * k) * squared_sine);
}

}  // namespace scb
