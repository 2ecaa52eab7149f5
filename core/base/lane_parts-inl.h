// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_LANE_PARTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_LANE_PARTS_INL_H_
#undef SCB_CORE_LANE_PARTS_INL_H_
#else
#define SCB_CORE_LANE_PARTS_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

template <class Make, std::size_t... i>
HWY_INLINE auto lane_parts(const Make& make, std::index_sequence<i...>) {
    return std::array<decltype(make(0)), sizeof...(i)>{make(i)...};
}

/// A value in `count` vectors: make(0), make(1) and so on. Each is created with its value, since
/// GCC 12 refuses vectors of 64-bit ARM without one.
template <std::size_t count, class Make>
HWY_INLINE auto lane_parts(const Make& make) {
    return lane_parts(make, std::make_index_sequence<count>());
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
