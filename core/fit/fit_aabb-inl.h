// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_AABB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_AABB_INL_H_
#undef SCB_CORE_FIT_AABB_INL_H_
#else
#define SCB_CORE_FIT_AABB_INL_H_
#endif

#include <algorithm>

#include "core/fit/fit_input.h"
#include "scb/aabb.h"
#include "scb/fit.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// From the first three directions of the DOP. Subtraction rounds monotonically, so a box that
/// contains both ends contains all points, to the last bit.
template <bool exact>
void fit(BasicAabb<exact>& result, const FitInput& input, const FitOptions&, FitCounts&) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double lower = input.dop->lower[i], upper = input.dop->upper[i];
        const double center = 0.5 * lower + 0.5 * upper;
        const auto axis = static_cast<Eigen::Index>(i);
        result.center[axis] = center;
        result.half[axis] = std::max(upper - center, center - lower);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
