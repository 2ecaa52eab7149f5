// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FLOAT_PLACEMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FLOAT_PLACEMENT_INL_H_
#undef SCB_CORE_FLOAT_PLACEMENT_INL_H_
#else
#define SCB_CORE_FLOAT_PLACEMENT_INL_H_
#endif

#include "core/base/lanes-inl.h"
#include "core/packed/grown_slab.h"
#include "scb/placement.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The placement of B in A's frame, for differences of close points in floats.
struct FloatPlacement {
    double columns[4][4] = {};  ///< columns of the rotation, and the translation
    float row[3][3];            ///< rows of the rotation
    float double_error;         ///< the error of doubles, see BasicPlacement

    explicit FloatPlacement(const Placement& placed) : double_error(float_above(placed.margin)) {
        for (int i = 0; i < 3; ++i) {
            columns[3][i] = placed.b_to_a.translation[i];
            for (int k = 0; k < 3; ++k) {
                columns[k][i] = placed.b_to_a.rotation(i, k);
                row[i][k] = static_cast<float>(placed.b_to_a.rotation(i, k));
            }
        }
    }
};

template <int n>
HWY_INLINE Lanes3<n> rotate(const FloatPlacement& placed, Lanes3<n> p) {
    const auto along = [&](const float* r) HWY_ATTR {
        return Lanes<n>::all(r[0]) * p.x + Lanes<n>::all(r[1]) * p.y + Lanes<n>::all(r[2]) * p.z;
    };
    return {along(placed.row[0]), along(placed.row[1]), along(placed.row[2])};
}

/// The offset from an origin of A to an origin of B, in A's frame, and an upper bound of
/// coordinates computed from there, for points within `reach_a` and `reach_b` of their origins.
/// Four floats of `a` are read.
struct Offset {
    float t[4];
    float length;
};
HWY_INLINE Offset offset(const FloatPlacement& placed, const float* a, float reach_a,
                         const float* b, float reach_b) {
    // Three lanes of four.
    constexpr int n = 4 < int{HWY_LANES(double)} ? 4 : int{HWY_LANES(double)};
    const hn::FixedTag<double, n> d;
    const hn::FixedTag<float, n> f;
    Offset o;
    for (int i = 0; i < 4; i += n) {
        const auto column = [&placed, i, d](int k, float x) HWY_ATTR {
            return hn::Mul(hn::LoadU(d, placed.columns[k] + i), hn::Set(d, static_cast<double>(x)));
        };
        auto t = hn::Add(hn::Add(column(0, b[0]), column(1, b[1])), column(2, b[2]));
        t = hn::Sub(hn::Add(t, hn::LoadU(d, placed.columns[3] + i)),
                    hn::PromoteTo(d, hn::LoadU(f, a + i)));
        hn::StoreU(hn::DemoteTo(f, t), f, o.t + i);
    }
    o.length = reach_a + reach_b;
    for (int i = 0; i < 3; ++i) o.length += o.t[i] < 0 ? -o.t[i] : o.t[i];
    return o;
}

/// Half a unit in the last place of floats, relative.
inline constexpr float float_unit = 0x1p-24f;

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
