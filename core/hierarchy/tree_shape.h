#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scb/topology.h"

namespace scb {

/// No node, no triangle.
inline constexpr std::uint32_t no_index = UINT32_MAX;

/// How the nodes of a tree hang together, with any number of children; of whatever builder.
struct TreeShape {
    // Per node.
    std::vector<std::uint32_t> parents;  ///< the node that lists it as a child; of roots, and of
                                         ///< nodes that no root leads to, no_index
    std::vector<std::uint32_t> depths;   ///< no_index where no root leads to it
    std::vector<std::uint32_t> first_child, next_sibling;  ///< no_index: none

    std::vector<std::uint32_t> order;  ///< from the roots down, parents before children
    std::vector<std::uint32_t> roots;
    std::vector<std::uint32_t> holder;  ///< per item: the first node in `order` that has it;
                                        ///< no_index: none
    /// Further nodes that have an item, with the item, ascending: a triangle may be split between
    /// leaves.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> more_holders;

    std::size_t size() const { return parents.size(); }
    bool is_leaf(std::uint32_t node) const { return first_child[node] == no_index; }
    /// Whether a root leads to it.
    bool hangs(std::uint32_t node) const { return depths[node] != no_index; }
    /// All nodes that have the item, the first in `order` first.
    std::vector<std::uint32_t> holders_of(std::uint32_t item) const;
    /// Of whatever number: no_index where no node has it.
    std::uint32_t holder_of(std::uint32_t item) const {
        return item < holder.size() ? holder[item] : no_index;
    }
};

TreeShape tree_shape(const Topology& topology);

/// The nodes that cover a body at a level, see scb/level_cover.h.
std::vector<std::uint32_t> level_cover(const TreeShape& shape, int level);

/// The depth of the deepest node.
int depth(const TreeShape& shape);

/// Per node how many items it and the nodes below it hold first.
std::vector<std::uint32_t> items_below(const TreeShape& shape);

}  // namespace scb
