#pragma once

#include <limits>

namespace scb {

/// Of which nodes of a topology volumes are wanted: all, unless told otherwise, in one way or the
/// other.
struct FittedNodes {
    /// Those no deeper than that; the root has depth 0. Deeper ones keep the volume of a `V{}`.
    int deepest = std::numeric_limits<int>::max();

    /// Volumes that are only to be packed to leaves of up to so many triangles can leave out most
    /// single ones, half of all nodes: those that share a leaf with their neighbour whatever else
    /// is chosen, see collapse. These get no volumes that contain them, but unfitted ones of such
    /// a cost that collapse chooses the same as if they were fitted. Of types other than Scb and
    /// Scb2 all are fitted.
    int leaf_triangles = 1;
};

}  // namespace scb
