#include "scb/packed_scb.h"

#include <cmath>
#include <limits>

#include "core/packed/grown_scb.h"

namespace scb {
namespace {

// More than all roundings of the doubles that are computed here, so that decoded volumes hold
// points also where the reference volume holds them but for rounding.
constexpr double slack = 0x1p-40;

}  // namespace

float float_above(double value) {
    const auto nearest = static_cast<float>(value);
    if (static_cast<double>(nearest) >= value) return nearest;
    return std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

double blur_of(const Scb& scb, const Vec3& origin) {
    return 0x1p-51 * (origin.cwiseAbs().maxCoeff() + scb.c.cwiseAbs().maxCoeff());
}

GrownScb grown_about(const Scb& scb, const RoundedCenter& rounded) {
    const Vec3 shift = scb.c - rounded.c;
    const double blur = blur_of(scb, rounded.origin);
    const double reach = (scb.r + std::sqrt(squared_norm(shift)) + blur) * (1 + slack);
    // n'.(x - c') = n.(x - c) + n.(c - c') + (n' - n).(x - c')
    const double turned = std::sqrt(squared_norm(rounded.n - scb.n)) * reach;
    return {reach, (scb.e + scb.f) / 2 + dot(scb.n, shift),
            (scb.e - scb.f) / 2 + turned + blur + slack * reach};
}

double half_thickness(const GrownScb& grown, double m) { return grown.h + std::abs(grown.m - m); }

PackedScb packed(const Scb& scb, const Vec3& origin) {
    PackedScb result;
    RoundedCenter rounded{{}, {}, origin};
    for (int i = 0; i < 3; ++i) {
        result.c[i] = static_cast<float>(scb.c[i] - origin[i]);
        result.n[i] = static_cast<float>(scb.n[i]);
        rounded.c[i] = origin[i] + static_cast<double>(result.c[i]);
        rounded.n[i] = static_cast<double>(result.n[i]);
    }
    const GrownScb grown = grown_about(scb, rounded);
    result.r = float_above(grown.r);
    result.m = static_cast<float>(grown.m);
    result.h = float_above(half_thickness(grown, static_cast<double>(result.m)));
    return result;
}

bool contains(const PackedScb& scb, const Vec3& point) {
    const Vec3 d = {point[0] - static_cast<double>(scb.c[0]),
                    point[1] - static_cast<double>(scb.c[1]),
                    point[2] - static_cast<double>(scb.c[2])};
    const Vec3 n = {static_cast<double>(scb.n[0]), static_cast<double>(scb.n[1]),
                    static_cast<double>(scb.n[2])};
    const auto r = static_cast<double>(scb.r);
    return squared_norm(d) <= r * r &&
           std::abs(dot(n, d) - static_cast<double>(scb.m)) <= static_cast<double>(scb.h);
}

}  // namespace scb
