#pragma once

#include "scenes/scene/scene.h"
#include "tests/peers/pair_difference.h"
#include "tests/peers/peer_timing.h"

namespace scb {

/// What one peer did on a scene.
struct PeerResult {
    PairDifference difference;  ///< from the pairs of the reference
    double build_ms = 0;        ///< of both trees, processor time
    double bytes = 0;           ///< of both trees for each triangle; NaN where nobody knows
    PeerTimes times;
};

/// What the peers did on a scene, in their order.
struct SceneComparison {
    std::string scene;
    std::size_t triangles = 0;  ///< of both bodies
    std::vector<int> frames;
    std::vector<PeerResult> peers;
};

/// How far B is moved to tell pairs that barely meet, as a share of the size of A's box.
inline constexpr double closeness_share = 1e-6;

/// Builds all trees, compares the pairs of every peer with the reference's pairs in at most
/// `compared_frames` of the frames, then times the peers. Peers may have different first contacts:
/// of these it only compares whether there is one. The scene has two bodies, and the
/// reference is among the peers.
SceneComparison compare_peers(const scenes::Scene& scene, const std::vector<int>& frames,
                              std::span<const PeerKind> kinds, PeerQuery query,
                              std::size_t compared_frames, const PeerTiming& timing);

}  // namespace scb
