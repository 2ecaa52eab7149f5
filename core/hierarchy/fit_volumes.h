#pragma once

#include <vector>

#include "core/hierarchy/leaf_order.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// Fits a volume to the points of every node, bottom up: the 26-DOP and the surface moments of a
/// node come from its children, the rest of the fit from its points. The same volumes as fitting
/// each node by itself, on any number of threads. O(n log n).
///
/// Volumes that are only to be packed to leaves of up to `leaf_triangles` can leave out most single
/// triangles, half of all nodes: those that share a leaf with their neighbour whatever else is
/// chosen, see collapse. These get no volumes that contain them, but unfitted ones of so much
/// surface area that collapse chooses the same as if they were fitted. Of types other than Scb all
/// are fitted.
template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options = {}, int threads = 1, int leaf_triangles = 1);

/// Fits volumes of the kind to a topology; `ritter` sets FitOptions::ball_method.
AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options = {}, int threads = 1);

}  // namespace scb
