// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_BOX_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_BOX_LANES_INL_H_
#undef SCB_CORE_BOX_LANES_INL_H_
#else
#define SCB_CORE_BOX_LANES_INL_H_
#endif

#include <array>
#include <cstddef>

#include "core/base/double_lanes-inl.h"
#include "core/base/lane_parts-inl.h"
#include "core/hierarchy/primitives.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Eight doubles: the corners of a box as in Primitive, and two unused lanes. Minima are exact, so
/// the box of many triangles depends neither on their order nor on the width of vectors.
struct BoxLanes {
    static constexpr std::size_t lanes = 8;
    using Stored = std::array<double, lanes>;
    std::array<Doubles, lanes / double_lanes> part;

    /// The box of no triangles.
    static HWY_INLINE BoxLanes empty() {
        return {lane_parts<lanes / double_lanes>([](std::size_t)
                                                     HWY_ATTR { return Doubles::all(1e300); })};
    }
    static HWY_INLINE BoxLanes of(const Primitive& primitive) {
        static_assert(sizeof(Primitive) >= sizeof(Stored), "or the last lanes are not its own");
        return load(primitive.lower.data());
    }
    static HWY_INLINE BoxLanes load(const Stored& from) { return load(from.data()); }
    HWY_INLINE void store(Stored& to) const {
        for (std::size_t i = 0; i < part.size(); ++i) part[i].store(to.data() + i * double_lanes);
    }
    HWY_INLINE void add(const BoxLanes& other) {
        for (std::size_t i = 0; i < part.size(); ++i) part[i] = min(part[i], other.part[i]);
    }

  private:
    static HWY_INLINE BoxLanes load(const double* from) {
        return {lane_parts<lanes / double_lanes>(
            [from](std::size_t i) HWY_ATTR { return Doubles::load(from + i * double_lanes); })};
    }
};

/// The squared sum of a box's sides; infinite if the box is empty.
HWY_INLINE double squared_width_sum(const BoxLanes& box) {
    BoxLanes::Stored s;
    box.store(s);
    const double x = s[0] + s[3], y = s[1] + s[4], z = s[2] + s[5];
    const double sum = x + y + z;
    return sum * sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
