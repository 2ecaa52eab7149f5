#pragma once

#include <limits>

namespace scb {

/// The nodes of a topology that get volumes: all by default. At most one of the members may be set.
struct FittedNodes {
    /// Nodes down to this depth; the root has depth 0. Deeper nodes keep the volume `V{}`.
    int deepest = std::numeric_limits<int>::max();

    /// The largest leaf of a packed hierarchy, if the volumes are only packed. Most single
    /// triangles, half of all nodes, need no volume then: in any choice of collapse they share a
    /// leaf with their neighbour. They get unfitted volumes that do not contain them, with such a
    /// cost that collapse makes the same choices as with fitted volumes. For types other than Scb
    /// and Scb2, all nodes are fitted.
    int leaf_triangles = 1;
};

}  // namespace scb
