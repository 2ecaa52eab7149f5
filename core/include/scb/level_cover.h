#pragma once

#include <cstdint>
#include <vector>

#include "scb/hierarchy.h"

namespace scb {

/// The level that stands for all leaves, at any depth.
inline constexpr int leaf_level = -1;

/// The nodes that cover a body at a level: the nodes at that depth and the leaves above it, in the
/// order of Topology::nodes. `leaf_level`: all leaves.
std::vector<std::uint32_t> level_cover(const Topology& topology, int level);

/// The depth of the deepest node.
int depth(const Topology& topology);

}  // namespace scb
