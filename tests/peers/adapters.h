#pragma once

#include "scb/any_hierarchy.h"
#include "scb/packed_layout.h"
#include "tests/peers/peer.h"

namespace scb {

// One function for each adapter; those of libraries exist where CMake found their packages, see
// peers.cpp.

PeerKind reference_peer();
/// How a packed hierarchy is made.
struct PackedPeerOptions {
    PackedLayout layout;
    SplitMethod split = SplitMethod::section_3;
    VolumeKind volume = VolumeKind::scb;  ///< or scb2
};
PeerKind packed_peer(const PackedPeerOptions& options, int threads);
PeerKind fcl_peer();
PeerKind bullet_peer();
PeerKind ode_peer();
PeerKind embree_peer();
PeerKind cgal_peer();

}  // namespace scb
