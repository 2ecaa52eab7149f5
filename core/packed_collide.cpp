#include "core/packed_collide.h"

#include <algorithm>

#include "core/packed_query.h"

namespace scb {

template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options) {
    // As in query_placement, for the margin is that of the reference's volumes.
    const Placement placed = placement(b_to_a, 4 * a.hierarchy.reach, 4 * b.hierarchy.reach);
    const AnyPackedQuery query = PackedQuery<Codec>{&a.hierarchy, &b.hierarchy, &placed};
    const LeafQuery leaves = {a.hierarchy.leaves.data(), b.hierarchy.leaves.data(), &placed};
    PackedLists lists;
    lists.add(a.hierarchy.root, b.hierarchy.root);
    OpenPairs open;
    PackedFindings found;
    while (!lists.empty()) {
        divide_nodes(query, options.level, lists, found);
        test_leaves(leaves, options.level, lists.leaf_leaf, open, found);
    }
    decide_open(leaves, options.level, open, found);

    PackedCollision result{std::move(found.pairs), found.n_v, found.n_p, found.undecided.size()};
    for (const IndexPair& pair : found.undecided)
        if (triangles_overlap(corners(a.mesh, pair.a),
                              transform_corners(b_to_a, corners(b.mesh, pair.b))))
            result.pairs.push_back(pair);
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

#define SCB_COLLIDE(...)                                                                     \
    template PackedCollision collide_packed(const PackedCollider<__VA_ARGS__>&,              \
                                            const PackedCollider<__VA_ARGS__>&, const Pose&, \
                                            const PackedOptions&);
SCB_COLLIDE(FloatCodec<2>)
SCB_COLLIDE(FloatCodec<4>)
SCB_COLLIDE(FloatCodec<8>)
SCB_COLLIDE(QuantizedCodec<2>)
SCB_COLLIDE(QuantizedCodec<4>)
SCB_COLLIDE(QuantizedCodec<8>)
#undef SCB_COLLIDE

}  // namespace scb
