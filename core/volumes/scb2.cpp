#include "scb/scb2.h"

#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/volumes/scb2_reach.h"

namespace scb {
namespace {

using std::numbers::pi;

/// The area of a disc beyond a chord at the signed distance k from the center.
double segment(double radius, double k) {
    if (k < 0) return pi * radius * radius - segment(radius, -k);
    if (k >= radius) return 0;
    const double v = half_chord(radius, k);
    return radius * radius * arc_tangent(v, k) - k * v;
}

/// The integral of acos(k / s) over the heights from 0 to x, or to where s = k; s^2 = r^2 - x^2.
/// acos(k / s) is half the angle that a plane at the signed distance k cuts off the circle at each
/// height. A slab of a recording need not contain the center, so k and x may be below 0.
double cut_arcs(double r, double k, double x) {
    if (x < 0) return -cut_arcs(r, k, -x);
    if (k < 0) return pi * x - cut_arcs(r, -k, x);
    if (k >= r) return 0;
    const double w = half_chord(r, k);
    if (x >= w) return (r - k) * pi / 2;
    const double v = half_chord(w, x);
    return x * arc_tangent(v, k) - k * arc_tangent(x, v) + r * arc_tangent(k * x, r * v);
}

}  // namespace

Scb2Faces faces(const Scb2& s) {
    Scb2Faces result;
    const auto [first, second] = s.slabs;
    double arcs = pi * (first.e - first.f);
    for (const double k : {second.e, -second.f})
        for (const double height : {first.e, -first.f}) arcs -= cut_arcs(s.r, k, height);
    result.sphere = std::max(0.0, 2 * s.r * arcs);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slab &own = s.slabs[i], &other = s.slabs[1 - i];
        for (std::size_t side = 0; side < 2; ++side) {
            const double radius = half_chord(s.r, side == 0 ? own.e : own.f);
            result.planes[i][side] = std::max(
                0.0, pi * radius * radius - segment(radius, other.e) - segment(radius, -other.f));
        }
    }
    return result;
}

double surface_area(const Scb2& s) {
    const Scb2Faces f = faces(s);
    return f.sphere + (f.planes[0][0] + f.planes[0][1]) + (f.planes[1][0] + f.planes[1][1]);
}

double volume(const Scb2& s) {
    const Scb2Faces f = faces(s);
    double sum = s.r * f.sphere;
    for (std::size_t i = 0; i < 2; ++i)
        sum += s.slabs[i].e * f.planes[i][0] - s.slabs[i].f * f.planes[i][1];
    return sum / 3;
}

bool contains(const Scb2& s, const Vec3& point) {
    const Vec3 q = point - s.c;
    if (!(squared_norm(q) <= s.r * s.r)) return false;
    for (const Slab& slab : s.slabs) {
        const double h = dot(slab.n, q);
        if (!(slab.f <= h && h <= slab.e)) return false;
    }
    return true;
}

bool is_well_formed(const Scb2& s) {
    // An eighth of the rounding that the margin of a placement allows, see placement.
    constexpr double unit_error = 0x1p-50;
    for (const Slab& slab : s.slabs)
        if (!(std::abs(squared_norm(slab.n) - 1) <= unit_error) || !(-s.r <= slab.f) ||
            !(slab.f <= 0 && 0 <= slab.e) || !(slab.e <= s.r))
            return false;
    return s.c.allFinite() && std::isfinite(s.r) &&
           std::abs(dot(s.slabs[0].n, s.slabs[1].n)) <= unit_error;
}

double support(const Scb2& s, const Vec3& direction) {
    const Vec3 along(dot(s.slabs[0].n, direction), dot(s.slabs[1].n, direction),
                     dot(long_axis(s), direction));
    return scb2_reach(s, along, 1.0);
}

}  // namespace scb
