#pragma once

#include <cstdint>
#include <limits>
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

/// The place of a node without a volume.
inline constexpr std::uint32_t no_place = ~std::uint32_t{0};

/// Fits the volumes of fit_volumes to some nodes. `place` has the index of each node's volume in
/// the result, or no_place. `count`: of volumes. V is Scb or Scb2.
template <class V>
std::vector<V> fit_some(const Topology& topology, const LeafOrder& points,
                        const FitOptions& options, int threads,
                        const std::vector<std::uint32_t>& place, std::size_t count);

/// Fits volumes of a kind to a topology; `ritter` sets FitOptions::ball_method.
AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options = {}, int threads = 1,
                     const FittedNodes& wanted = {});

}  // namespace scb
