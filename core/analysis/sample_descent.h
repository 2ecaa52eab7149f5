#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scb/hierarchy.h"

namespace scb {

/// Calls `reached(node, depth)` for the nodes that `meets(node)` holds of, and of all nodes above
/// them: those at which a query would go on. `stack` is scratch space.
template <class Meets, class Reached>
void descend(const Topology& topology, Meets&& meets, Reached&& reached,
             std::vector<std::pair<std::uint32_t, std::uint32_t>>& stack) {
    stack.assign(1, {0, 0});
    while (!stack.empty()) {
        const auto [node, depth] = stack.back();
        stack.pop_back();
        if (!meets(node)) continue;
        reached(node, depth);
        if (topology.nodes[node].is_leaf()) continue;
        for (const std::uint32_t child : {topology.nodes[node].left, topology.nodes[node].left + 1})
            stack.push_back({child, depth + 1});
    }
}

}  // namespace scb
