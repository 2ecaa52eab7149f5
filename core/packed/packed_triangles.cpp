#include "core/base/simd_targets.h"
#include "core/packed/packed_query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/packed/packed_triangles.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/double_pairs-inl.h"
#include "core/packed/leaf_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

void test_leaves(const LeafQuery& query, RefPairs& pairs, OpenPairs& open, PackedFindings& found) {
    LeafPairs(query, open, found).run(pairs);
}

void decide_open(const LeafQuery& query, OpenPairs& open, PackedFindings& found) {
    LeafPairs(query, open, found).finish();
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(test_leaves);
HWY_EXPORT(decide_open);
HWY_EXPORT(decide_in_doubles);

void test_leaves(const LeafQuery& query, SimdLevel level, RefPairs& pairs, OpenPairs& open,
                 PackedFindings& found) {
    if (!pairs.empty()) SCB_AT_LEVEL(test_leaves, level)(query, pairs, open, found);
}

void decide_open(const LeafQuery& query, SimdLevel level, OpenPairs& open, PackedFindings& found) {
    if (open.count > 0) SCB_AT_LEVEL(decide_open, level)(query, open, found);
}

void decide_in_doubles(const Mesh& a, const Mesh& b, const Pose& b_to_a, SimdLevel level,
                       PackedFindings& found) {
    if (!found.undecided.empty()) SCB_AT_LEVEL(decide_in_doubles, level)(a, b, b_to_a, found);
}

}  // namespace scb
#endif
