#include "scb/packed_scb.h"

#include <cmath>

#include "core/packed/grown_slab.h"

namespace scb {

PackedScb packed(const Scb& scb, const Vec3& origin) {
    PackedScb result;
    Vec3 rounded_c, rounded_n;
    for (int i = 0; i < 3; ++i) {
        result.c[i] = static_cast<float>(scb.c[i] - origin[i]);
        result.n[i] = static_cast<float>(scb.n[i]);
        rounded_c[i] = origin[i] + static_cast<double>(result.c[i]);
        rounded_n[i] = static_cast<double>(result.n[i]);
    }
    const MovedBall ball(scb.c, scb.r, rounded_c, origin);
    const GrownSlab slab(scb.n, scb.e, scb.f, rounded_n, ball);
    result.r = float_above(ball.r);
    result.m = static_cast<float>(slab.m);
    result.h = float_above(slab.half_about(static_cast<double>(result.m)));
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
