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

    /// The options that the topology depends on.
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

/// Topology and volumes at once. Throws InputError as check_mesh does, and if the margin is below 0
/// or not a number. `name` is the name of the mesh in the message.
template <Volume V>
Hierarchy<V> build_hierarchy(const Mesh& mesh, const BuildOptions& options = {},
                             std::string_view name = "mesh");

/// Checks that the hierarchy is valid for this mesh: every triangle is in exactly one leaf, the
/// ranges of two children make up the range of their parent, and every vertex of a node's triangles
/// is contained in its volume. Returns an empty string if so, else a sentence that names the first
/// invalid node. O(n log n).
template <Volume V>
std::string validate(const Hierarchy<V>& hierarchy, const Mesh& mesh);

/// The first part of `validate`, which needs no volumes.
std::string validate(const Topology& topology, const Mesh& mesh);

}  // namespace scb
