#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scb/topology.h"

namespace scb {

/// No node, no triangle.
inline constexpr std::uint32_t no_index = UINT32_MAX;

/// The links of a tree's nodes, with any number of children.
struct TreeShape {
    // Per node.
    std::vector<std::uint32_t> parents;  ///< no_index for roots and unreachable nodes
    std::vector<std::uint32_t> depths;   ///< no_index for unreachable nodes
    std::vector<std::uint32_t> first_child, next_sibling;  ///< no_index: none

    std::vector<std::uint32_t> order;  ///< from the roots down, parents before children
    std::vector<std::uint32_t> roots;
    /// Per item the first node in `order` that has the item; no_index: none.
    std::vector<std::uint32_t> holder;
    /// (item, node) for each further node that has the item, ascending: a triangle may be split
    /// between leaves.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> more_holders;

    std::size_t size() const { return parents.size(); }
    bool is_leaf(std::uint32_t node) const { return first_child[node] == no_index; }
    /// Whether a root leads to the node.
    bool is_reachable(std::uint32_t node) const { return depths[node] != no_index; }
    /// All nodes that have the item, the first in `order` first.
    std::vector<std::uint32_t> holders_of(std::uint32_t item) const;
    /// The first node that has the item; no_index if none has it, also for numbers out of range.
    std::uint32_t holder_of(std::uint32_t item) const {
        return item < holder.size() ? holder[item] : no_index;
    }
};

TreeShape tree_shape(const Topology& topology);

/// The nodes that cover a body at a level, see scb/level_cover.h.
std::vector<std::uint32_t> level_cover(const TreeShape& shape, int level);

/// The depth of the deepest node.
int depth(const TreeShape& shape);

/// Per node the number of items that are first held by the node or by nodes below it.
std::vector<std::uint32_t> items_below(const TreeShape& shape);

}  // namespace scb
