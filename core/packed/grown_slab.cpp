#include "core/packed/grown_slab.h"

#include <cmath>
#include <limits>
#include <utility>

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

namespace {

Slab turned_around(const Slab& slab) { return {-slab.n, -slab.f, -slab.e}; }

}  // namespace

TurnedSlabs::TurnedSlabs(const Scb2& scb) : slabs(scb.slabs) {
    auto& [first, second] = slabs;
    if (second.e - second.f < first.e - first.f) std::swap(first, second);
    // The first of the four turns, by 0 or by half a circle about an axis, with the largest trace.
    // The four scalar parts are the components of one quaternion.
    const Vec3 line = cross(first.n, second.n);
    const double a = first.n[0], b = second.n[1], c = line[2];
    const std::array<double, 4> traces = {a + b + c, a - b - c, b - a - c, c - a - b};
    std::size_t best = 0;
    for (std::size_t i = 1; i < traces.size(); ++i)
        if (traces[i] > traces[best]) best = i;
    if (best >= 2) first = turned_around(first);
    if (best % 2 == 1) second = turned_around(second);
    const Vec3 axis = cross(first.n, second.n);
    const double w = std::sqrt(1 + traces[best]) / 2;
    q = Vec3(second.n[2] - axis[1], axis[0] - first.n[2], first.n[1] - second.n[0]) / (4 * w);
}

}  // namespace scb
