#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/hierarchy/mesh_topology.h"
#include "scb/any_hierarchy.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// The nodes of a topology that get volumes: all by default.
struct FittedNodes {
    /// Nodes down to this depth; the root has depth 0. Deeper nodes keep the volume `V{}`.
    int deepest = std::numeric_limits<int>::max();
};

/// Fits a volume to the points of every node, bottom up: the 26-DOP and the surface moments of a
/// node come from its children, the rest of the fit from its points. The volumes are the same as if
/// each node was fitted by itself, for any number of threads. O(n log n).
template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options = {}, int threads = 1,
                           const FittedNodes& wanted = {});

/// The volumes of the nodes that may be part of a packed hierarchy. Most single triangles, half of
/// all nodes, have none: in any choice of collapse they share a leaf with their neighbour.
template <class V>
struct PackableVolumes {
    /// The visit_cost of each node. For a triangle without a volume, at most the cost of any volume
    /// that contains it, so that collapse makes the same choices as with volumes of all nodes.
    std::vector<float> costs;
    /// Of the nodes with children. Each has the place of its pair of children among all such pairs.
    std::vector<V> inner;
    /// Of single triangles, by the index of the node, ascending.
    std::vector<std::pair<std::uint32_t, V>> triangles;

    /// The volume of a node of the topology, which must have one.
    const V& of(const Topology& topology, std::uint32_t node) const {
        const TopologyNode& at = topology.nodes[node];
        if (!at.is_leaf()) return inner[place_of_inner(at)];
        const auto found = std::lower_bound(
            triangles.begin(), triangles.end(), node,
            [](const auto& triangle, std::uint32_t i) { return triangle.first < i; });
        assert(found != triangles.end() && found->first == node && "a node with a volume");
        return found->second;
    }
    /// The root is followed by pairs of children.
    static std::size_t place_of_inner(const TopologyNode& node) { return (node.left - 1) / 2; }
};

/// The volumes of fit_volumes that a packed hierarchy with leaves of at most `leaf_triangles` may
/// need. V is Scb or Scb2.
template <class V>
PackableVolumes<V> fit_for_packing(const Topology& topology, const LeafOrder& points,
                                   const FitOptions& options, int threads, int leaf_triangles);

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
