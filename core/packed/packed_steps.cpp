#include "core/packed/packed_steps.h"

#include "core/base/simd_targets.h"
#include "scb/packed_collide.h"

// Compiled for the static target alone: for every target, the twelve codecs would double the time
// to compile the traversal.
#include <hwy/highway.h>
// After the line above.
#include "core/packed/packed_traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

void divide_nodes(const AnyPackedQuery& query, PackedSteps& steps, PackedLists& lists,
                  PackedFindings& found) {
    std::visit(
        [&]<class Codec>(const PackedQuery<Codec>& some) {
            PackedTraversal<Codec, PackedSteps&>(some, lists, found, steps).run();
        },
        query);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

namespace scb {

void divide_nodes(const AnyPackedQuery& query, PackedSteps& steps, PackedLists& lists,
                  PackedFindings& found) {
    HWY_STATIC_DISPATCH(divide_nodes)(query, steps, lists, found);
}

PackedSteps::PackedSteps(CalledObserver& observer, const LeafQuery& leaves, const Mesh& a,
                         const Mesh& b)
    : numbers_(observer), leaves_(leaves), a_(a), b_(b), b_to_a_(leaves.placed->b_to_a) {}

void PackedSteps::begin(RefPair roots) { add(roots, {no_step, 0, 0}); }

void PackedSteps::test(RefPair pair, bool overlap, RefPair parent) {
    Overlap next = overlaps_.at(key(parent));
    next.depth_a += pair.a.bits != parent.a.bits;
    next.depth_b += pair.b.bits != parent.b.bits;
    next.step = numbers_.volume_test({pair.a.bits, pair.b.bits, next.depth_a, next.depth_b},
                                     overlap ? Stage::overlapping : packed_rejection, next.step);
    if (overlap) add(pair, next);
}

void PackedSteps::add(RefPair pair, const Overlap& overlap) {
    if (pair.a.is_leaf() && pair.b.is_leaf())
        test_items(pair, overlap.step);
    else
        overlaps_.emplace(key(pair), overlap);
}

void PackedSteps::test_items(RefPair pair, std::uint32_t step) {
    const PackedLeaf leaf_a{leaves_.a.words + pair.a.index()},
        leaf_b{leaves_.b.words + pair.b.index()};
    for (std::uint32_t i = 0; i < leaf_a.count(); ++i)
        for (std::uint32_t j = 0; j < leaf_b.count(); ++j) {
            const IndexPair items{leaf_a.triangle(i), leaf_b.triangle(j)};
            numbers_.item_test({items, step, triangles_meet(a_, b_, b_to_a_, items), false});
        }
}

}  // namespace scb
