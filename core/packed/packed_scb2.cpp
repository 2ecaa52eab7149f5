#include "scb/packed_scb2.h"

#include <cmath>

#include "core/packed/grown_slab.h"
#include "core/packed/packed_axes-inl.h"

// Functions inlined from it need the same target.
HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {
namespace {

PackedAxes<float> axes_of(const PackedScb2& scb) {
    return packed_axes(scb.q[0], scb.q[1], scb.q[2], 1.0f);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

namespace scb {

std::array<Vec3, 2> normals(const PackedScb2& scb) {
    const auto axes = HWY_NAMESPACE::axes_of(scb);
    const auto normal = [&](const float* n) {
        return Vec3(static_cast<double>(n[0]), static_cast<double>(n[1]),
                    static_cast<double>(n[2]));
    };
    return {normal(axes.axis[0]), normal(axes.axis[1])};
}

PackedScb2 packed(const Scb2& scb, const Vec3& origin) {
    const TurnedSlabs turned(scb);
    PackedScb2 result;
    Vec3 rounded;
    for (int i = 0; i < 3; ++i) {
        result.c[i] = static_cast<float>(scb.c[i] - origin[i]);
        result.q[i] = static_cast<float>(turned.q[i]);
        rounded[i] = origin[i] + static_cast<double>(result.c[i]);
    }
    const MovedBall ball(scb.c, scb.r, rounded, origin);
    result.r = float_above(ball.r);
    const std::array<Vec3, 2> n = normals(result);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slab& from = turned.slabs[i];
        const GrownSlab slab(from.n, from.e, from.f, n[i], ball);
        result.m[i] = static_cast<float>(slab.m);
        result.h[i] = float_above(slab.half_about(static_cast<double>(result.m[i])));
    }
    return result;
}

bool contains(const PackedScb2& scb, const Vec3& point) {
    const Vec3 d = point - center(scb);
    const auto r = static_cast<double>(scb.r);
    if (!(squared_norm(d) <= r * r)) return false;
    const std::array<Vec3, 2> n = normals(scb);
    for (std::size_t i = 0; i < 2; ++i)
        if (!(std::abs(dot(n[i], d) - static_cast<double>(scb.m[i])) <=
              static_cast<double>(scb.h[i])))
            return false;
    return true;
}

}  // namespace scb
