// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_OBB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_OBB_INL_H_
#undef SCB_CORE_FIT_OBB_INL_H_
#else
#define SCB_CORE_FIT_OBB_INL_H_
#endif

#include "core/fit/fit_input.h"
#include "core/fit/point_passes-inl.h"
#include "scb/fit.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

HWY_INLINE void fit(Obb& result, const FitInput& input, const FitOptions&, FitCounts&) {
    result.axes = box_axes(input);
    const Vec3 origin = input.parts[0].size > 0 ? input.parts[0][0] : input.parts[1][0];
    result.center = origin;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = result.axes.col(i);
        Interval interval;
        for (const PointsView& part : input.parts) extend(interval, part, origin, axis);
        result.center += 0.5 * (interval.lower + interval.upper) * axis;
    }
    // Measured again from the rounded center, so that every point is inside to the last bit.
    for (int i = 0; i < 3; ++i) {
        Interval interval;
        for (const PointsView& part : input.parts)
            extend(interval, part, result.center, result.axes.col(i));
        result.half[i] = std::max(interval.upper, -interval.lower) + 0.0;  // 0 for -0
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
