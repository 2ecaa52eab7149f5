#include "tests/core/packed/gap_keys.h"

#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/packed/gap_keys.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/gap_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The kernel's key of a pair, with a margin of so many units; of gap_bound where they are
/// negative.
template <class Packed>
float key_of(const VolumesOfNodes<Packed>& pair, const Placement& placement, float units) {
    using L = LaneVolumes<Packed, part_lanes(4)>;
    const FloatPlacement in_floats(placement);
    const Offset o = offset(in_floats, pair.origin_a, pair.reach_a, pair.origin_b, pair.reach_b);
    const L b = placed(L::all(pair.b), in_floats, Lanes3<L::n>::all(o.t));
    const float margin =
        (units < 0 ? gap_bound<Packed> : units) * float_unit * o.length + in_floats.double_error;
    float keys[L::n];
    gap(L::all(pair.a), b, Lanes<L::n>::all(margin), Lanes<L::n>::all(HUGE_VALF)).store(keys);
    return keys[0];
}
float key_of_one_slab(const VolumesOfNodes<PackedScb>& pair, const Placement& placed, float units) {
    return key_of(pair, placed, units);
}
float key_of_two_slabs(const VolumesOfNodes<PackedScb2>& pair, const Placement& placed,
                       float units) {
    return key_of(pair, placed, units);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace scb {

HWY_EXPORT(key_of_one_slab);
HWY_EXPORT(key_of_two_slabs);

float gap_key(SimdLevel level, const VolumesOfNodes<PackedScb>& pair, const Placement& placed,
              float units) {
    return SCB_AT_LEVEL(key_of_one_slab, level)(pair, placed, units);
}
float gap_key(SimdLevel level, const VolumesOfNodes<PackedScb2>& pair, const Placement& placed,
              float units) {
    return SCB_AT_LEVEL(key_of_two_slabs, level)(pair, placed, units);
}

}  // namespace scb

#endif
