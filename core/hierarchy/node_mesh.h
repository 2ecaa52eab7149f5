#pragma once

#include "scb/mesh.h"
#include "scb/topology.h"

namespace scb {

/// The triangles below a node as a mesh, in the order of the topology, with the vertices that they
/// use. `mesh` is the mesh of the topology.
Mesh node_mesh(const Mesh& mesh, const Topology& topology, std::uint32_t node);

}  // namespace scb
