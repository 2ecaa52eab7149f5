#pragma once

#include "core/packed/packed_query.h"
#include "scb/packed_collide.h"

namespace scb {

// The sides of a query, as traversals and kernels see them.

template <class Codec>
PackedLeaves leaves_of(const PackedCollider<Codec>& side) {
    const bool stored = side.hierarchy.corners == LeafCorners::stored;
    return {side.hierarchy.leaves.data(), stored ? nullptr : &side.mesh};
}

// As in query_placement, since the margin is the margin of the reference's volumes.
template <class Codec>
Placement placement_of(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                       const Pose& b_to_a) {
    return placement(b_to_a, 4 * a.hierarchy.reach, 4 * b.hierarchy.reach);
}

}  // namespace scb
