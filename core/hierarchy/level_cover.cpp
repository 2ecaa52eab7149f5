#include "scb/level_cover.h"

#include <algorithm>

namespace scb {

std::vector<std::uint32_t> level_cover(const Topology& topology, int level) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    std::vector<std::uint32_t> cover;
    for (std::uint32_t i = 0; i < depths.size(); ++i) {
        const bool leaf = topology.nodes[i].is_leaf();
        if (level == leaf_level ? leaf : depths[i] == level || (leaf && depths[i] < level))
            cover.push_back(i);
    }
    return cover;
}

int depth(const Topology& topology) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    return *std::max_element(depths.begin(), depths.end());
}

}  // namespace scb
