#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/hierarchy/tree_shape.h"

namespace scb {

/// Calls `reached(node, depth)` for each node if `meets` is true of the node and of all nodes above
/// it: the nodes that a query would reach. `stack` is scratch space.
template <class Meets, class Reached>
void descend(const TreeShape& shape, Meets&& meets, Reached&& reached,
             std::vector<std::pair<std::uint32_t, std::uint32_t>>& stack) {
    stack.clear();
    for (const std::uint32_t root : shape.roots) stack.emplace_back(root, 0);
    while (!stack.empty()) {
        const auto [node, depth] = stack.back();
        stack.pop_back();
        if (!meets(node)) continue;
        reached(node, depth);
        for (std::uint32_t child = shape.first_child[node]; child != no_index;
             child = shape.next_sibling[child])
            stack.emplace_back(child, depth + 1);
    }
}

}  // namespace scb
