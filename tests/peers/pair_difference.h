#pragma once

#include <span>

#include "scb/collide.h"
#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb {

/// Pairs that only one of two answers has, and how close their triangles are.
struct UnsharedPairs {
    std::size_t count = 0;
    std::size_t degenerate = 0;  ///< one of the triangles has no area
    /// Of the others, those whose answer changes where B is moved by `closeness`: they barely meet
    /// or barely miss each other.
    std::size_t close = 0;
};

/// How a peer's pairs differ from the reference's pairs, in all frames that were compared.
struct PairDifference {
    std::size_t frames = 0;
    std::size_t pairs = 0;  ///< of the reference
    UnsharedPairs missing;  ///< that only the reference has
    UnsharedPairs extra;    ///< that only the peer has

    bool none() const { return missing.count == 0 && extra.count == 0; }
};

/// Where two bodies are, for saying why a pair is in one answer only.
struct PairScene {
    const Mesh& a;
    const Mesh& b;
    Pose b_to_a;
    double closeness = 0;  ///< a length
};

/// Adds one frame. Both lists are sorted.
void add_frame(PairDifference& difference, std::span<const IndexPair> reference,
               std::span<const IndexPair> found, const PairScene& scene);

}  // namespace scb
