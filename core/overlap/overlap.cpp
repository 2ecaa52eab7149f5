#include "scb/overlap.h"

#include "core/overlap/test_functors.h"
#include "scb/placement.h"

namespace scb {

template <Volume V>
Stage overlap(const V& a, const V& b, const Pose& b_to_a, const OverlapOptions& options) {
    const Placement placed = placement(b_to_a, reach(a), reach(b));
    return with_overlap_test<V>(options, [&](auto test) { return test(a, b, placed); });
}

template Stage overlap(const Scb&, const Scb&, const Pose&, const OverlapOptions&);
template Stage overlap(const Scb2&, const Scb2&, const Pose&, const OverlapOptions&);
template Stage overlap(const Ball&, const Ball&, const Pose&, const OverlapOptions&);
template Stage overlap(const Obb&, const Obb&, const Pose&, const OverlapOptions&);

}  // namespace scb
