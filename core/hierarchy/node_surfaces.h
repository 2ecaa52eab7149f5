#pragma once

#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/mesh.h"

namespace scb {

/// For each node, the area of the triangles in it and below it, in squared units of the mesh.
/// `shape` is the shape of a tree of `mesh`.
std::vector<double> node_surfaces(const TreeShape& shape, const Mesh& mesh);

}  // namespace scb
