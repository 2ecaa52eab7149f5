// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOP26_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOP26_INL_H_
#undef SCB_CORE_DOP26_INL_H_
#else
#define SCB_CORE_DOP26_INL_H_
#endif

#include "core/base/double_lanes-inl.h"
#include "core/fit/dop26.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Some directions of a DOP.
struct DopLanes {
    Doubles upper, lower, upper_id, lower_id;

    static HWY_INLINE DopLanes load(const Dop26& dop, std::size_t i) {
        return {Doubles::load(&dop.upper[i]), Doubles::load(&dop.lower[i]),
                Doubles::load(&dop.upper_id[i]), Doubles::load(&dop.lower_id[i])};
    }
    HWY_INLINE void store(Dop26& dop, std::size_t i) const {
        upper.store(&dop.upper[i]);
        lower.store(&dop.lower[i]);
        upper_id.store(&dop.upper_id[i]);
        lower_id.store(&dop.lower_id[i]);
    }
    /// The DOP of a single point. Rounded by two additions at most.
    static HWY_INLINE DopLanes of_point(const Doubles3& point, double id, std::size_t i) {
        const auto& d = dop26_directions;
        const Doubles along = Doubles::load(&d.x[i]) * point.x + Doubles::load(&d.y[i]) * point.y +
                              Doubles::load(&d.z[i]) * point.z;
        return {along, along, Doubles::all(id), Doubles::all(id)};
    }
    /// The DOP of two sets. If values are equal, the smaller id counts.
    friend HWY_INLINE DopLanes merge(const DopLanes& a, const DopLanes& b) {
        const auto b_upper =
            (a.upper < b.upper) | ((a.upper == b.upper) & (b.upper_id < a.upper_id));
        const auto b_lower =
            (b.lower < a.lower) | ((a.lower == b.lower) & (b.lower_id < a.lower_id));
        return {select(b_upper, b.upper, a.upper), select(b_lower, b.lower, a.lower),
                select(b_upper, b.upper_id, a.upper_id), select(b_lower, b.lower_id, a.lower_id)};
    }
};

/// Makes `a` the DOP of both.
HWY_INLINE void merge_into(Dop26& a, const Dop26& b) {
    for (std::size_t i = 0; i < Dop26::padded; i += double_lanes)
        merge(DopLanes::load(a, i), DopLanes::load(b, i)).store(a, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
