#include "core/model/packed_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

/// The triangles of the binary nodes at or below a node.
std::set<std::uint32_t> triangles_below(const Topology& topology, std::uint32_t node) {
    const auto first = topology.order.begin() + topology.nodes[node].first;
    return {first, first + topology.nodes[node].count};
}

void expect_tree_of(const Mesh& mesh, const PackedLayout& layout) {
    const Hierarchy<Scb2> hierarchy = build_hierarchy<Scb2>(mesh);
    const Topology& topology = *hierarchy.topology;
    const PackedTree tree = packed_tree(pack_any(layout, hierarchy, mesh), topology);
    ASSERT_FALSE(tree.nodes.empty());
    EXPECT_EQ(tree.nodes[0].node, 0u);
    EXPECT_EQ(tree.nodes[0].parent, no_index);
    EXPECT_EQ(tree.binary.size(), tree.nodes.size());
    std::set<std::uint32_t> nodes, in_leaves;
    for (const PackedTreeNode& node : tree.nodes) {
        EXPECT_TRUE(nodes.insert(node.node).second) << "twice: " << node.node;
        EXPECT_EQ(node.parent == no_index, node.node == 0);
        EXPECT_TRUE(node.parent == no_index || nodes.contains(node.parent));
        EXPECT_NE(node.items.empty(), node.children.empty());
        EXPECT_LE(node.items.size(), static_cast<std::size_t>(layout.leaf_triangles));
        EXPECT_LE(node.children.size(), static_cast<std::size_t>(layout.width));
        const std::set<std::uint32_t> below = triangles_below(topology, node.node);
        std::set<std::uint32_t> of_children(node.items.begin(), node.items.end());
        for (const std::uint32_t child : node.children)
            of_children.merge(triangles_below(topology, child));
        EXPECT_EQ(of_children, below) << node.node;
        in_leaves.insert(node.items.begin(), node.items.end());
    }
    EXPECT_EQ(in_leaves.size(), mesh.triangles.size());
}

TEST(PackedTree, HasNodesOfTheBinaryHierarchyWithTheirTriangles) {
    for (PackedLayout layout : all_packed_layouts())
        for (const int leaf : {1, most_leaf_triangles}) {
            layout.leaf_triangles = leaf;
            SCOPED_TRACE(packed_layout_name(layout) + " " + std::to_string(leaf));
            expect_tree_of(random_soup(3, 200, 0.2), layout);
        }
}

TEST(PackedTree, OfOneLeafIsTheRoot) {
    PackedLayout layout = all_packed_layouts().front();
    layout.leaf_triangles = most_leaf_triangles;
    expect_tree_of(random_soup(3, 1, 0.2), layout);
    expect_tree_of(random_soup(3, 3, 0.2), layout);
}

}  // namespace
}  // namespace scb
