#include "core/packed/grown_slab.h"

#include <cmath>
#include <limits>

namespace scb {
namespace {

// More than all roundings of doubles in this file, so that decoded volumes also contain points that
// the reference volume contains up to rounding.
constexpr double slack = 0x1p-40;

}  // namespace

float float_above(double value) {
    constexpr auto none = std::numeric_limits<float>::infinity();
    if (value > std::numeric_limits<float>::max()) return none;
    const auto nearest = static_cast<float>(value);
    if (static_cast<double>(nearest) >= value) return nearest;
    return std::nextafter(nearest, none);
}

double blur_of(const Vec3& c, const Vec3& origin) {
    // The smallest numbers have no last place.
    return 0x1p-51 * (origin.cwiseAbs().maxCoeff() + c.cwiseAbs().maxCoeff()) +
           std::numeric_limits<double>::min();
}

MovedBall::MovedBall(const Vec3& c, double radius, const Vec3& rounded, const Vec3& origin)
    : shift(c - rounded),
      blur(blur_of(c, origin)),
      r((radius + std::sqrt(squared_norm(shift)) + blur) * (1 + slack)) {}

GrownSlab::GrownSlab(const Vec3& n, double e, double f, const Vec3& rounded,
                     const MovedBall& ball) {
    // n'.(x - c') = n.(x - c) + n.(c - c') + (n' - n).(x - c')
    const double turned = std::sqrt(squared_norm(rounded - n)) * ball.r;
    m = (e + f) / 2 + dot(n, ball.shift);
    h = (e - f) / 2 + turned + ball.blur + slack * ball.r;
}

double GrownSlab::half_about(double middle) const { return h + std::abs(m - middle); }

}  // namespace scb
