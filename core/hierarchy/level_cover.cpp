#include "scb/level_cover.h"

#include <algorithm>

#include "core/hierarchy/tree_shape.h"

namespace scb {

std::vector<std::uint32_t> level_cover(const Topology& topology, int level) {
    return level_cover(tree_shape(topology), level);
}

int depth(const Topology& topology) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    return *std::max_element(depths.begin(), depths.end());
}

}  // namespace scb
