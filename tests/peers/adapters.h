#pragma once

#include "scb/packed_layout.h"
#include "tests/peers/peer.h"

namespace scb {

// One function for each adapter. The functions of a library exist if CMake found its package, see
// peers.cpp.

PeerKind reference_peer();
/// How a packed hierarchy is made.
struct PackedPeerOptions {
    PackedLayout layout;
    bool by_cost = false;    ///< how nodes are split
    bool two_slabs = false;  ///< volumes
};
PeerKind packed_peer(const PackedPeerOptions& options, int threads);
PeerKind fcl_peer();
PeerKind bullet_peer();
PeerKind ode_peer();
PeerKind embree_peer();
PeerKind cgal_peer();

}  // namespace scb
