#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// A change of the mesh with which the nodes of a tree contain the triangles below them.
struct TreeFit {
    std::string what;         ///< "a rotation by 35 degrees about z"
    std::uint64_t nodes = 0;  ///< nodes that contain the triangles below them with it
    std::uint64_t of = 0;     ///< nodes with volumes
};

/// Another mesh, with as many triangles, that the tree may have been built for, and its name.
struct OtherMesh {
    std::string what;
    std::function<Mesh()> mesh;  ///< called if no earlier mesh fits
};

/// Looks for one change of the mesh that explains why `outside` nodes do not contain the triangles
/// below them. Tries `others` first. If `outside` is at least eight and a quarter of the nodes,
/// tries more: a mirror, another order of the axes, common bounds, another order of the triangles,
/// and a similarity. Returns the first change that leaves at most a tenth of `outside`, or nothing.
/// The mesh must be finite.
std::optional<TreeFit> find_tree_fit(const EngineNodes& tree, const TreeShape& shape,
                                     const Mesh& mesh, double tolerance, std::uint64_t outside,
                                     std::span<const OtherMesh> others);

/// An order of the triangles, per item one, with which each leaf contains the triangles of its
/// items, and most leaves end where these end. An engine that takes places in a sorted list for
/// triangles has such leaves. No value if no order fits, or if the search takes too long.
std::optional<std::vector<std::uint32_t>> find_triangle_order(const EngineNodes& tree,
                                                              const TreeShape& shape,
                                                              const Mesh& mesh, double tolerance);

}  // namespace scb
