#pragma once

#include "scb/distance.h"
#include "scb/hierarchy.h"
#include "scb/packed_distance.h"
#include "tests/peers/distance_peer.h"

namespace scb {

/// Two bodies, with the hierarchies of this project.
struct DistanceBodies {
    DistanceBodies(const Mesh& a, const Mesh& b);

    struct Body {
        explicit Body(const Mesh& from);
        Mesh mesh;
        Hierarchy<Scb2> reference;
        PackedHierarchy<QuickestCodec> packed;
        PackedHierarchy<QuantizedCodec<8, Scb>> one_slab;
    };
    Body a, b;
};

/// The hierarchies of a peer of this project.
enum class DistanceTree { reference, packed, packed_one_slab };

/// Queries of these bodies, which outlive the peer. `seeded`: each query begins with the closest
/// triangles of the query before at the same pose.
std::unique_ptr<DistancePeer> own_distance_peer(const DistanceBodies& bodies, DistanceTree tree,
                                                DistanceOrder order, bool seeded = false);

}  // namespace scb
