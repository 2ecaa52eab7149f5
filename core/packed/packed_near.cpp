#include "core/base/simd_targets.h"
#include "core/packed/near_search.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/packed/packed_near.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/double_distance-inl.h"
#include "core/packed/gap_traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

void find_near(const AnyPackedQuery& nodes, const LeafQuery& leaves, std::size_t heap,
               NearSearch& search) {
    std::visit(
        [&]<class Codec>(const PackedQuery<Codec>& query) {
            GapTraversal<Codec>(query, leaves, heap, search).run();
        },
        nodes);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(find_near);
HWY_EXPORT(distances_apart);

void find_near(const AnyPackedQuery& nodes, const LeafQuery& leaves, SimdLevel level,
               std::size_t heap, NearSearch& search) {
    SCB_AT_LEVEL(find_near, level)(nodes, leaves, heap, search);
}

void distances_apart(const Mesh& a, const Mesh& b, const Pose& b_to_a, SimdLevel level,
                     std::span<const IndexPair> pairs, double* distances) {
    SCB_AT_LEVEL(distances_apart, level)(a, b, b_to_a, pairs, distances);
}

}  // namespace scb
#endif
