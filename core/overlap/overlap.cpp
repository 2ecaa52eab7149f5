#include "scb/overlap.h"

#include "core/overlap/test_functors.h"
#include "scb/placement.h"

namespace scb {

template <Volume V>
Stage overlap(const V& a, const V& b, const Pose& b_to_a, const OverlapOptions& options) {
    const Placement placed = placement(b_to_a, reach(a), reach(b));
    return with_overlap_test<V>(options, [&](auto test) { return test(a, b, placed); });
}

#define SCB_INSTANTIATE(V) \
    template Stage overlap(const V&, const V&, const Pose&, const OverlapOptions&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
