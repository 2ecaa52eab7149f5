#pragma once

#include <cstdint>
#include <vector>

#include "core/hierarchy.h"

namespace scb {

/// The level that means all leaves, wherever they are.
inline constexpr int leaf_level = -1;

/// The nodes that cover a body at a level: those at that depth, and the leaves above it. In the
/// order of the nodes. `leaf_level`: all leaves.
std::vector<std::uint32_t> level_cover(const Topology& topology, int level);

/// The volumes of a cover in numbers; lengths as in LevelStatistics.
struct CoverStatistics {
    std::uint32_t volumes = 0;
    std::uint32_t leaves = 0;  ///< of the volumes
    double mean_diameter = 0, mean_thickness = 0;
    double area = 0, volume = 0;  ///< summed
};

template <Volume V>
CoverStatistics cover_statistics(const Hierarchy<V>& hierarchy,
                                 const std::vector<std::uint32_t>& cover) {
    CoverStatistics s;
    for (const std::uint32_t node : cover) {
        const V& v = hierarchy.volumes[node];
        ++s.volumes;
        s.leaves += hierarchy.topology->nodes[node].is_leaf();
        s.mean_diameter += diameter(v);
        s.mean_thickness += thickness(v);
        s.area += surface_area(v);
        s.volume += volume(v);
    }
    if (s.volumes != 0) {
        s.mean_diameter /= s.volumes;
        s.mean_thickness /= s.volumes;
    }
    return s;
}

/// The depth of the deepest node.
int depth(const Topology& topology);

}  // namespace scb
