#pragma once

#include <memory>

#include "core/hierarchy/leaf_order.h"
#include "scb/topology.h"

namespace scb {

/// What all hierarchies of a mesh share, whatever their volumes.
struct MeshTopology {
    std::shared_ptr<const Topology> topology;
    LeafOrder points;
};

/// `mesh` must satisfy check_mesh. The same for any number of threads.
MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options = {});

}  // namespace scb
