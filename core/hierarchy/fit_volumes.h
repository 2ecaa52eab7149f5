#pragma once

#include <vector>

#include "core/hierarchy/fitted_nodes.h"
#include "core/hierarchy/leaf_order.h"
#include "scb/any_hierarchy.h"

namespace scb {

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

}  // namespace scb
