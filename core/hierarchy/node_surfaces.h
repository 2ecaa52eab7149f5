#pragma once

#include <vector>

#include "scb/mesh.h"
#include "scb/topology.h"

namespace scb {

/// For each node the area of the triangles below it, in squared units of the mesh. `mesh` is the
/// one that the topology is of.
std::vector<double> node_surfaces(const Topology& topology, const Mesh& mesh);

}  // namespace scb
