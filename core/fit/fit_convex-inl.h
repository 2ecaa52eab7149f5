// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_CONVEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_CONVEX_INL_H_
#undef SCB_CORE_FIT_CONVEX_INL_H_
#else
#define SCB_CORE_FIT_CONVEX_INL_H_
#endif

#include "core/fit/fit_input.h"
#include "scb/convex.h"
#include "scb/fit.h"
#include "scb/fit_points.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Calls the `fit` of the volume's own header.
template <ConvexVolume V>
void fit(V& result, const FitInput& input, const FitOptions&, FitCounts&) {
    scb::fit(result, FitPoints(input));
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
