#pragma once

#include "scb/mesh.h"
#include "scb/topology.h"

namespace scb {

/// The triangles below a node as a mesh of their own, in the order of the topology; of the vertices
/// those that they use. `mesh` is the one that the topology is of.
Mesh node_mesh(const Mesh& mesh, const Topology& topology, std::uint32_t node);

}  // namespace scb
