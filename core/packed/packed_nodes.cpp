#include "core/base/simd_targets.h"
#include "core/packed/packed_query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/packed/packed_nodes.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/packed_traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

void divide_nodes(const AnyPackedQuery& query, const PackedPace& pace, PackedLists& lists,
                  PackedFindings& found) {
    std::visit(
        [&]<class Codec>(const PackedQuery<Codec>& some) {
            PackedTraversal<Codec>(some, lists, found).run(pace);
        },
        query);
}

void divide_once(const AnyPackedQuery& query, PackedLists& lists, PackedFindings& found) {
    std::visit(
        [&]<class Codec>(const PackedQuery<Codec>& some) {
            PackedTraversal<Codec>(some, lists, found).run_once();
        },
        query);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(divide_nodes);
HWY_EXPORT(divide_once);

void divide_nodes(const AnyPackedQuery& query, SimdLevel level, const PackedPace& pace,
                  PackedLists& lists, PackedFindings& found) {
    SCB_AT_LEVEL(divide_nodes, level)(query, pace, lists, found);
}

void divide_once(const AnyPackedQuery& query, SimdLevel level, PackedLists& lists,
                 PackedFindings& found) {
    SCB_AT_LEVEL(divide_once, level)(query, lists, found);
}

}  // namespace scb
#endif
