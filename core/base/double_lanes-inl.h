// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_LANES_INL_H_
#undef SCB_CORE_DOUBLE_LANES_INL_H_
#else
#define SCB_CORE_DOUBLE_LANES_INL_H_
#endif

#include <cassert>
#include <cstddef>

#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Up to 8 doubles in one vector.
inline constexpr std::size_t double_lanes = part_lanes<double>(8);
using Doubles = Lanes<double_lanes, double>;
using Doubles3 = Lanes3<double_lanes, double>;

/// The first index of `value`, which must be among the numbers. `count` is a multiple of the
/// vector's size.
HWY_INLINE std::size_t first_equal(const double* numbers, std::size_t count, double value) {
    for (std::size_t i = 0; i < count; i += double_lanes) {
        const auto equal = (Doubles::load(numbers + i) == Doubles::all(value)).v;
        if (!hn::AllFalse(Doubles::D(), equal))
            return i + static_cast<std::size_t>(hn::FindFirstTrue(Doubles::D(), equal));
    }
    assert(false && "one of them is");
    return 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
