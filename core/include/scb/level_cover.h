#pragma once

#include <cstdint>
#include <vector>

#include "core/hierarchy/volume_statistics.h"
#include "scb/hierarchy.h"

namespace scb {

/// The level that means all leaves, wherever they are.
inline constexpr int leaf_level = -1;

/// The nodes that cover a body at a level: those at that depth, and the leaves above it. In the
/// order of the nodes. `leaf_level`: all leaves.
std::vector<std::uint32_t> level_cover(const Topology& topology, int level);

/// The volumes of a cover in numbers.
template <Volume V>
VolumeStatistics cover_statistics(const Hierarchy<V>& hierarchy,
                                  const std::vector<std::uint32_t>& cover) {
    VolumeStatistics statistics;
    for (const std::uint32_t node : cover)
        statistics.add(hierarchy.volumes[node], hierarchy.topology->nodes[node].is_leaf());
    return statistics;
}

/// The depth of the deepest node.
int depth(const Topology& topology);

}  // namespace scb
