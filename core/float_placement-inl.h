// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FLOAT_PLACEMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FLOAT_PLACEMENT_INL_H_
#undef SCB_CORE_FLOAT_PLACEMENT_INL_H_
#else
#define SCB_CORE_FLOAT_PLACEMENT_INL_H_
#endif

#include "core/lanes-inl.h"
#include "core/packed_scb.h"
#include "core/placement.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Where B is seen from A, for differences of points that are close together in floats.
struct FloatPlacement {
    Pose b_to_a;
    float row[3][3];     ///< of the rotation
    float double_error;  ///< what doubles may be off by, see BasicPlacement

    explicit FloatPlacement(const Placement& placed)
        : b_to_a(placed.b_to_a), double_error(float_above(placed.margin)) {
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) row[i][k] = static_cast<float>(b_to_a.rotation(i, k));
    }
};

template <int n>
HWY_INLINE Lanes3<n> rotate(const FloatPlacement& placed, Lanes3<n> p) {
    const auto along = [&](const float* r) {
        return Lanes<n>::all(r[0]) * p.x + Lanes<n>::all(r[1]) * p.y + Lanes<n>::all(r[2]) * p.z;
    };
    return {along(placed.row[0]), along(placed.row[1]), along(placed.row[2])};
}

/// An origin of B from one of A, in A's frame, and a length that no coordinate exceeds that is
/// computed from there: of `reach` are things around both origins.
struct Offset {
    float t[3];
    float length;
};
HWY_INLINE Offset offset(const FloatPlacement& placed, const float* a, float reach_a,
                         const float* b, float reach_b) {
    Offset o;
    o.length = reach_a + reach_b;
    const Mat3& r = placed.b_to_a.rotation;
    const double x = b[0], y = b[1], z = b[2];
    for (int i = 0; i < 3; ++i) {
        o.t[i] = static_cast<float>(r(i, 0) * x + r(i, 1) * y + r(i, 2) * z +
                                    placed.b_to_a.translation[i] - static_cast<double>(a[i]));
        o.length += o.t[i] < 0 ? -o.t[i] : o.t[i];
    }
    return o;
}

/// Half a unit in the last place of floats, relatively.
inline constexpr float float_unit = 0x1p-24f;

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
