#include "core/packed_collide.h"

#include "core/packed_query.h"
#include "core/pair_sort.h"

namespace scb {

struct PackedWorkspace::Parts {
    PackedLists lists;
    OpenPairs open;
    PackedFindings found;
    std::vector<IndexPair> room;
};

PackedWorkspace::PackedWorkspace() : parts_(std::make_unique<Parts>()) {}
PackedWorkspace::~PackedWorkspace() = default;
PackedWorkspace::PackedWorkspace(PackedWorkspace&&) noexcept = default;
PackedWorkspace& PackedWorkspace::operator=(PackedWorkspace&&) noexcept = default;

template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options,
                               PackedWorkspace* workspace) {
    if (workspace == nullptr) {
        PackedWorkspace own;
        return collide_packed(a, b, b_to_a, options, &own);
    }
    auto& [lists, open, found, room] = workspace->parts();
    // As in query_placement, for the margin is that of the reference's volumes.
    const Placement placed = placement(b_to_a, 4 * a.hierarchy.reach, 4 * b.hierarchy.reach);
    const AnyPackedQuery query = PackedQuery<Codec>{&a.hierarchy, &b.hierarchy, &placed};
    const LeafQuery leaves = {a.hierarchy.leaves.data(), b.hierarchy.leaves.data(), &placed};
    found.clear();
    lists.add(a.hierarchy.root, b.hierarchy.root);
    while (!lists.empty()) {
        divide_nodes(query, options.level, lists, found);
        test_leaves(leaves, options.level, lists.leaf_leaf, open, found);
    }
    decide_open(leaves, options.level, open, found);

    for (const IndexPair& pair : found.undecided)
        if (triangles_overlap(corners(a.mesh, pair.a),
                              transform_corners(b_to_a, corners(b.mesh, pair.b))))
            found.pairs.push_back(pair);
    sort_pairs(found.pairs, room);
    return {found.pairs, found.n_v, found.n_p, found.undecided.size()};
}

#define SCB_COLLIDE(Codec)                                                             \
    template PackedCollision collide_packed(const PackedCollider<Codec>&,              \
                                            const PackedCollider<Codec>&, const Pose&, \
                                            const PackedOptions&, PackedWorkspace*);
SCB_FOR_EACH_CODEC(SCB_COLLIDE)
#undef SCB_COLLIDE

}  // namespace scb
