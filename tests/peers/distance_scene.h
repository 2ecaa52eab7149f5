#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/peers/peer_timing.h"
#include "tests/peers/scb_distance.h"

namespace scb {

/// The bodies of a comparison, and where they are.
struct DistanceScene {
    std::string name;
    bool is_smooth = false;  ///< a scan or a smooth shape; else a CAD model
    double gap = 0;          ///< of the largest side of A
    std::vector<PeerPoses> poses;
};

/// The mesh, scaled and moved so that its box is centered and its longest side is 1.
Mesh normalized(const Mesh& mesh);

/// Random poses of B in which the bodies are this far apart, to 1e-6 of the gap. The same on every
/// machine.
std::vector<PeerPoses> poses_at_gap(const DistanceBodies& bodies, double gap, std::size_t count);

}  // namespace scb
