#pragma once

#include <memory>

#include "core/hierarchy/leaf_order.h"
#include "scb/hierarchy.h"

namespace scb {

/// What all hierarchies of a mesh share, whatever their volumes.
struct MeshTopology {
    std::shared_ptr<const Topology> topology;
    LeafOrder points;
};

/// `mesh` must satisfy check_mesh. The same for any number of threads.
MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options = {});

/// The same for a mesh and options from outside. Throws InputError, naming the mesh, where
/// check_mesh does and where the margin is below 0 or not a number.
MeshTopology checked_topology(const Mesh& mesh, const BuildOptions& options, std::string_view name);

}  // namespace scb
