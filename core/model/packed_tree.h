#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/any_packed.h"
#include "scb/topology.h"

namespace scb {

/// A node or leaf of a packed hierarchy, under the index of the binary node that it was made from.
struct PackedTreeNode {
    std::uint32_t node = 0, parent = no_index;   ///< no_index: the root
    std::vector<std::uint32_t> children, items;  ///< `items`: triangles; of a leaf only
};

/// The links of a packed hierarchy. Its nodes are some nodes of the binary hierarchy that was
/// packed, and have indices of that hierarchy.
struct PackedTree {
    std::vector<PackedTreeNode> nodes;  ///< parents first
    /// By the bits of a PackedRef, the binary node. Never iterated.
    std::unordered_map<std::uint32_t, std::uint32_t> binary;
};

/// `topology`: of the hierarchy that was packed. O(n).
PackedTree packed_tree(const AnyPacked& packed, const Topology& topology);

}  // namespace scb
