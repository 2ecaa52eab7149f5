#pragma once

#include <memory>

#include "core/hierarchy/leaf_order.h"
#include "scb/hierarchy.h"

namespace scb {

/// The data that all hierarchies of a mesh share, for any volumes.
struct MeshTopology {
    std::shared_ptr<const Topology> topology;
    LeafOrder points;
};

/// `mesh` must satisfy check_mesh. The same for any number of threads.
MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options = {});

/// The same for a mesh and options from outside. Throws InputError, naming the mesh, as check_mesh
/// does, and if the margin is below 0 or not a number.
MeshTopology checked_topology(const Mesh& mesh, const BuildOptions& options, std::string_view name);

}  // namespace scb
