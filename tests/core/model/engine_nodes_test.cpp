#include "core/model/engine_nodes.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_tree.h"

namespace scb {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Recorded from the leaves up, with numbers that are no indices.
std::vector<ToldNode> row_from_below() {
    std::vector<ToldNode> nodes = nodes_of_row();
    std::reverse(nodes.begin(), nodes.end());
    for (ToldNode& node : nodes) {
        node.number += 10;
        if (node.parent != no_index) node.parent += 10;
        for (std::uint32_t& child : node.children) child += 10;
    }
    return nodes;
}

TEST(EngineNodes, GoesByNumbersAsTheEngineTellsThem) {
    const EngineNodes tree = tree_of(row_from_below());
    ASSERT_EQ(tree.size(), 7u);
    EXPECT_EQ(tree.index_of(16), 0u);
    EXPECT_EQ(tree.index_of(10), 6u);
    EXPECT_EQ(tree.index_of(6), no_index);
    EXPECT_EQ(tree.parent(0), 12u);
    EXPECT_EQ(tree.parent(6), no_index);
    EXPECT_EQ(Indices(tree.children(6).begin(), tree.children(6).end()), (Indices{11, 12}));
    EXPECT_EQ(Indices(tree.items(0).begin(), tree.items(0).end()), Indices{3});
    EXPECT_TRUE(tree.children(0).empty());
}

TEST(EngineNodes, TheSecondNodeOfANumberIsNotTaken) {
    auto nodes = nodes_of_row();
    nodes.push_back({3, 2, {}, {0, 1, 2}, {}});
    const EngineNodes tree = tree_of(nodes);
    EXPECT_EQ(tree.size(), 7u);
    EXPECT_EQ(tree.recorded_twice(), Indices{3});
    EXPECT_EQ(tree.items(3).size(), 1u);
    EXPECT_EQ(tree.parent(3), 1u);
}

TEST(EngineNodes, ParentsAreToldWhereTheyAreNotAllTheSame) {
    const std::uint32_t leaf = 1;
    const auto parents = [&](std::array<std::uint32_t, 3> told) {
        const EngineNodes tree = tree_of({{0, told[0], std::vector(1, leaf), {}, {}},
                                          {leaf, told[1], {}, {}, {}},
                                          {2, told[2], {}, {}, {}}});
        return Indices{tree.parent(0), tree.parent(1), tree.parent(2)};
    };
    EXPECT_EQ(parents({no_index, 0, no_index}), (Indices{no_index, 0, no_index}));
    EXPECT_EQ(parents({no_index, 0, 0}), (Indices{no_index, 0, 0}));
    EXPECT_EQ(parents({0, 0, 0}), (Indices{no_index, no_index, no_index}));
}

TEST(EngineNodes, AVolumeTakesThePlaceOfTheOneBeforeAndOfItsFault) {
    EngineNodes tree = tree_of(nodes_of_row());
    tree.set_volume(2, {}, 4, "its radius is negative");
    EXPECT_FALSE(has_volume(tree[2].volume));
    EXPECT_EQ(tree.volume_fault(2), "its radius is negative");
    EXPECT_EQ(tree[2].recorded_at, 4);
    tree.set_volume(3, {}, 4, "its half is not finite");
    tree.set_volume(2, Ball{Vec3::Zero(), 1}, 5, "");
    EXPECT_TRUE(has_volume(tree[2].volume));
    EXPECT_EQ(tree.volume_fault(2), "");
    EXPECT_EQ(tree[2].recorded_at, 5);
    EXPECT_EQ(tree.volume_fault(1), "");
    EXPECT_EQ(tree.volume_fault(3), "its half is not finite");
}

TEST(EngineNodes, NamesItsNodes) {
    EngineNodes tree;
    EngineNode node;
    node.number = 12;
    tree.add(node, "arm", {}, {});
    node.number = 13;
    tree.add(node, "", {}, {});
    EXPECT_EQ(tree.words(0), "node 12 \"arm\"");
    EXPECT_EQ(tree.words(1), "node 13");
    EXPECT_EQ(tree.name_of(1), "");
}

TEST(EngineNodes, ItsShapeGoesDownFromTheRootsChildByChild) {
    const EngineNodes tree = tree_of(row_from_below());
    const TreeShape shape = tree_shape(tree, 4);
    // 10, 11, 13, 14, 12, 15, 16.
    EXPECT_EQ(shape.order, (Indices{6, 5, 3, 2, 4, 1, 0}));
    EXPECT_EQ(shape.roots, Indices{6});
    EXPECT_EQ(shape.parents, (Indices{4, 4, 5, 5, 6, 6, no_index}));
    EXPECT_EQ(shape.depths, (Indices{2, 2, 2, 2, 1, 1, 0}));
    EXPECT_EQ(shape.first_child[6], 5u);
    EXPECT_EQ(shape.next_sibling[5], 4u);
    EXPECT_EQ(shape.next_sibling[4], no_index);
    EXPECT_EQ(shape.holder, (Indices{3, 2, 1, 0}));
}

TEST(EngineNodes, AnItemIsHeldByTheFirstNodeFromTheRootDown) {
    auto nodes = nodes_of_row();
    nodes[0].items = {2};
    nodes[3].items = {0, 3, 4};
    const TreeShape shape = tree_shape(tree_of(nodes), 4);
    EXPECT_EQ(shape.holder, (Indices{3, 4, 0, 3}));
    EXPECT_EQ(shape.holder_of(4), no_index) << "there are four";
}

TEST(EngineNodes, WhatNoRootLeadsToHasNoPlace) {
    auto nodes = nodes_of_row();
    nodes[2].children = {5};     // 6 says that 2 is its parent
    nodes[6].children = {2, 9};  // 9 is none
    const TreeShape shape = tree_shape(tree_of(nodes), 4);
    EXPECT_EQ(shape.roots, Indices{0});
    EXPECT_FALSE(shape.is_reachable(6));
    EXPECT_EQ(shape.parents[6], no_index);
    EXPECT_EQ(shape.parents[2], 0u) << "and not 6";
    EXPECT_EQ(shape.holder_of(3), no_index);
}

TEST(EngineNodes, OneThatOnlyIsACycleIsEnteredAtTheFirstNode) {
    const TreeShape shape =
        tree_shape(tree_of({{0, 2, {1}, {}, {}}, {1, 0, {2}, {}, {}}, {2, 1, {0}, {}, {}}}), 0);
    EXPECT_EQ(shape.order, (Indices{0, 1, 2}));
    EXPECT_EQ(shape.parents, (Indices{no_index, 0, 1}));
}

}  // namespace
}  // namespace scb
