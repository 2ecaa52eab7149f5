#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/hierarchy/build_options.h"
#include "core/hierarchy/leaf_order.h"
#include "scb/topology.h"
#include "scb/volume.h"

namespace scb {

/// A bounding volume hierarchy: a topology, which several hierarchies may share, and a volume for
/// each of its nodes, in the body frame of the mesh.
template <Volume V>
struct Hierarchy {
    std::shared_ptr<const Topology> topology;
    std::vector<V> volumes;
};

/// Fits a volume to the points of every node, bottom up: the 26-DOP and the surface moments of a
/// node come from its children, the rest of the fit from its points. The same volumes as fitting
/// each node by itself, on any number of threads. O(n log n).
template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options = {}, int threads = 1);

/// Topology and volumes at once. Throws InputError where check_mesh does and where the margin is
/// below 0 or not a number; `name` says which mesh it is.
template <Volume V>
Hierarchy<V> build_hierarchy(const Mesh& mesh, const BuildOptions& options = {},
                             std::string_view name = "mesh");

/// Checks that the hierarchy is one of this mesh: every triangle in exactly one leaf, the ranges of
/// two children make up their parent's, and every vertex of a node's triangles is contained in its
/// volume. Empty where all holds, else a sentence that names the first node at which it does not.
/// O(n log n).
template <Volume V>
std::string validate(const Hierarchy<V>& hierarchy, const Mesh& mesh);

/// The first part of `validate`, which needs no volumes.
std::string validate(const Topology& topology, const Mesh& mesh);

}  // namespace scb
