#include "core/hierarchy/tree_shape.h"

#include <algorithm>
#include <numeric>

#include "scb/level_cover.h"

namespace scb {

TreeShape tree_shape(const Topology& topology) {
    const auto size = static_cast<std::uint32_t>(topology.nodes.size());
    TreeShape shape;
    shape.parents.assign(size, no_index);
    shape.depths.assign(size, 0);
    shape.first_child.assign(size, no_index);
    shape.next_sibling.assign(size, no_index);
    shape.order.resize(size);
    std::iota(shape.order.begin(), shape.order.end(), 0u);
    shape.roots = {0};
    shape.holder.assign(topology.order.size(), no_index);
    // Parents come before their children.
    for (std::uint32_t i = 0; i < size; ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            shape.holder[topology.order[node.first]] = i;
            continue;
        }
        shape.first_child[i] = node.left;
        shape.next_sibling[node.left] = node.left + 1;
        for (const std::uint32_t child : {node.left, node.left + 1}) {
            shape.parents[child] = i;
            shape.depths[child] = shape.depths[i] + 1;
        }
    }
    return shape;
}

std::vector<std::uint32_t> TreeShape::holders_of(std::uint32_t item) const {
    std::vector<std::uint32_t> nodes;
    if (holder_of(item) == no_index) return nodes;
    nodes.push_back(holder_of(item));
    const auto from =
        std::lower_bound(more_holders.begin(), more_holders.end(), item,
                         [](const auto& more, std::uint32_t i) { return more.first < i; });
    for (auto more = from; more != more_holders.end() && more->first == item; ++more)
        nodes.push_back(more->second);
    return nodes;
}

std::vector<std::uint32_t> level_cover(const TreeShape& shape, int level) {
    std::vector<std::uint32_t> cover;
    for (std::uint32_t i = 0; i < shape.size(); ++i) {
        if (!shape.is_reachable(i)) continue;
        const auto depth = static_cast<int>(shape.depths[i]);
        const bool leaf = shape.is_leaf(i);
        if (level == leaf_level ? leaf : depth == level || (leaf && depth < level))
            cover.push_back(i);
    }
    return cover;
}

int depth(const TreeShape& shape) {
    int deepest = 0;
    for (const std::uint32_t depth : shape.depths)
        if (depth != no_index) deepest = std::max(deepest, static_cast<int>(depth));
    return deepest;
}

std::vector<std::uint32_t> items_below(const TreeShape& shape) {
    std::vector<std::uint32_t> counts(shape.size(), 0);
    for (const std::uint32_t node : shape.holder)
        if (node != no_index) ++counts[node];
    for (auto node = shape.order.rbegin(); node != shape.order.rend(); ++node)
        if (shape.parents[*node] != no_index) counts[shape.parents[*node]] += counts[*node];
    return counts;
}

std::vector<std::uint32_t> level_cover(const Topology& topology, int level) {
    return level_cover(tree_shape(topology), level);
}

int depth(const Topology& topology) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    return *std::max_element(depths.begin(), depths.end());
}

}  // namespace scb
