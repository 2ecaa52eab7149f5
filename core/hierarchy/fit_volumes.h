#pragma once

#include <limits>
#include <vector>

#include "core/hierarchy/mesh_topology.h"
#include "scb/any_hierarchy.h"
#include "scb/scb.h"
#include "scb/scb2.h"

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

/// Fits a volume to the points of every node, bottom up: the 26-DOP and the surface moments of a
/// node come from its children, the rest of the fit from its points. The volumes are the same as if
/// each node was fitted by itself, for any number of threads. O(n log n).
template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options = {}, int threads = 1,
                           const FittedNodes& wanted = {});

/// Fits volumes of a kind to a topology; `ritter` sets FitOptions::ball_method.
AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options = {}, int threads = 1,
                     const FittedNodes& wanted = {});

/// How likely a query is to visit a node with this volume, up to a factor. Packed hierarchies
/// choose their nodes by it, see collapse.
inline double visit_cost(const Scb& scb) { return surface_area(scb); }

/// For two slabs, the squared sum of the widths along the three axes, as in splits by cost. With
/// it, CAD models need 0.9 to 1.0 of the volume tests that they need with the area, and it takes no
/// arc function.
inline double visit_cost(const Scb2& scb) {
    double sum = 2 * scb.r;
    for (const Slab& slab : scb.slabs) sum += slab.e - slab.f;
    return sum * sum;
}

}  // namespace scb
