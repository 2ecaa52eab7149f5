#pragma once

#include <algorithm>
#include <vector>

#include "scb/topology.h"

namespace scb {

/// The depth of the deepest node.
inline int depth_of(const Topology& topology) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    return *std::max_element(depths.begin(), depths.end());
}

}  // namespace scb
