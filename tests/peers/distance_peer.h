#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/peers/peer.h"

namespace scb {

/// A library with the trees of two meshes, ready for queries of their distance. The time of
/// `query` is measured.
class DistancePeer : public Peer {
  public:
    /// What the last query found.
    virtual double distance() const = 0;
    /// Tests of volumes and of triangles of the last query; 0 if they are not counted.
    virtual std::uint64_t n_v() const { return 0; }
    virtual std::uint64_t n_p() const { return 0; }

    std::vector<IndexPair> pairs() const override { return {}; }
};

/// FCL's distance with trees of RSS, or with OBBs that test overlap and RSS that bound distances.
std::unique_ptr<DistancePeer> fcl_distance_peer(const PeerMesh& a, const PeerMesh& b,
                                                bool with_obbs);
std::string fcl_version();

}  // namespace scb
