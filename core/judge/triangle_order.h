#pragma once

#include <optional>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// An order of the triangles, per item one, with which each leaf contains the triangles of its
/// items, and most leaves end where these end. An engine that takes places in a sorted list for
/// triangles has such leaves. Nothing where there is none, or where the search takes too long.
std::optional<std::vector<std::uint32_t>> find_triangle_order(const EngineNodes& tree,
                                                              const TreeShape& shape,
                                                              const Mesh& mesh, double tolerance);

}  // namespace scb
