#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scb/fit.h"
#include "scb/topology.h"
#include "scb/volume.h"

namespace scb {

/// How a hierarchy is built.
struct BuildOptions {
    /// How its volumes are fitted.
    FitOptions fit{};
    /// How its nodes are divided.
    SplitMethod split = SplitMethod::section_3;
    /// How many threads build it; it is the same for any number.
    int threads = 1;

    /// What of this the topology depends on.
    TopologyOptions topology() const { return {split, threads, fit.simd}; }
};

/// A bounding volume hierarchy: a topology, which several hierarchies may share, and a volume for
/// each of its nodes, in the body frame of the mesh.
template <Volume V>
struct Hierarchy {
    /// Its nodes; never null in a hierarchy that was built.
    std::shared_ptr<const Topology> topology;
    /// The volumes, one for each of Topology::nodes, in their order.
    std::vector<V> volumes;
};

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
