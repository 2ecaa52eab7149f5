#include "core/judge/tree_check.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_tree.h"

namespace scb {
namespace {

std::vector<std::string> problems_of(const std::vector<ToldNode>& nodes, bool with_mesh = true,
                                     double tolerance = 1e-9) {
    const Mesh mesh = row_of_triangles();
    EngineNodes tree = tree_of(nodes);
    tree.has_objects = !with_mesh;
    const TreeShape shape = tree_shape(tree, with_mesh ? mesh.triangles.size() : 0);
    std::vector<std::string> words;
    for (const auto& problems :
         {check_shape(tree, shape, with_mesh ? &mesh : nullptr),
          check_volumes(tree, shape, with_mesh ? &mesh : nullptr, tolerance)})
        for (const TreeProblem& problem : problems) words.push_back(words_of(problem, tree));
    return words;
}

using Words = std::vector<std::string>;

TEST(TreeCheck, AValidTreeHasNoProblems) {
    EXPECT_EQ(problems_of(nodes_of_row()), Words{});
    EXPECT_EQ(problems_of(nodes_of_row(), false), Words{});
}

TEST(TreeCheck, NamesWhatIsWrongWithTheShape) {
    auto nodes = nodes_of_row();
    nodes.push_back(nodes[3]);
    EXPECT_EQ(problems_of(nodes), Words{"node 3 is described twice"});

    nodes = nodes_of_row();
    nodes[2].children.push_back(9);
    EXPECT_EQ(problems_of(nodes), Words{"node 2 lists node 9, which is not described"});

    nodes = nodes_of_row();
    nodes[2].children.push_back(3);
    EXPECT_EQ(problems_of(nodes), Words{"node 3 is a child of two nodes, the second is node 2"});

    nodes = nodes_of_row();
    nodes[5].parent = 1;
    EXPECT_EQ(problems_of(nodes), Words{"node 5 names node 1 as its parent, but is a child of "
                                        "another node"});

    nodes = nodes_of_row();
    nodes[2].children = {5};
    EXPECT_EQ(problems_of(nodes),
              (Words{"node 6 names node 2 as its parent, but is not among that node's children: no "
                     "query reaches it",
                     "triangle 3 is in no leaf"}));
}

TEST(TreeCheck, AnEngineNeedNotKnowParents) {
    for (const std::uint32_t same : {0u, 77u, no_index}) {
        auto nodes = nodes_of_row();
        for (ToldNode& node : nodes) node.parent = same;
        EXPECT_EQ(problems_of(nodes), Words{}) << same;
    }
}

TEST(TreeCheck, NamesWhatIsInACycle) {
    auto nodes = nodes_of_row();
    nodes[0].children = {1};
    nodes[2].parent = 6;
    nodes[6].children = {2};
    nodes[6].items = {};
    EXPECT_EQ(problems_of(nodes),
              (Words{"node 2 is in a cycle, or below one", "node 5 is in a cycle, or below one",
                     "node 6 is in a cycle, or below one", "triangle 2 is in no leaf",
                     "triangle 3 is in no leaf"}));
    // One that only is a cycle is entered somewhere.
    for (const Words& words : {problems_of({{0, 1, {1}, {}, {}}, {1, 0, {0}, {}, {}}}),
                               problems_of({{0, 0, {0}, {0}, {}}})})
        EXPECT_EQ(words.front(), "node 0 is in a cycle, or below one");
    // Of a tree without nodes nothing is known.
    EXPECT_EQ(problems_of({}), Words{});
}

TEST(TreeCheck, NamesTrianglesThatAreInNoLeafOrThatThereAreNot) {
    auto nodes = nodes_of_row();
    nodes[4].items = {2};
    EXPECT_EQ(problems_of(nodes), Words{"triangle 1 is in no leaf"})
        << "triangle 2 is in two leaves, and one of them has it";
    nodes = nodes_of_row();
    nodes[4].items = {1, 4};
    EXPECT_EQ(problems_of(nodes), Words{"node 4 has triangle 4, which the mesh does not have"});
}

// A builder with spatial splits gives each of two leaves a part of a triangle.
TEST(TreeCheck, LeavesOfOneTriangleContainItTogether) {
    auto nodes = nodes_of_row();
    nodes[4].items = {1, 0};
    nodes[3].volume = box_of_row(0, 0.25 - 0.5);
    EXPECT_EQ(problems_of(nodes).size(), 1u);
}

TEST(TreeCheck, NamesVerticesThatAreNotFinite) {
    const EngineNodes tree = tree_of(nodes_of_row());
    Mesh mesh = row_of_triangles();
    mesh.vertices[4][1] = NAN;
    const auto problems = check_shape(tree, tree_shape(tree, 4), &mesh);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(words_of(problems[0], tree), "triangle 1 has vertex 4, which is not finite");
    EXPECT_EQ(check_volumes(tree, tree_shape(tree, 4), &mesh, 1e-9).size(), 0u);
}

TEST(TreeCheck, NamesVolumesThatDoNotContainWhatIsBelowThem) {
    auto nodes = nodes_of_row();
    nodes[1].volume = box_of_row(0, 0.75);
    EXPECT_EQ(problems_of(nodes), Words{"node 1 does not contain triangle 1, by 0.25"});
    EXPECT_EQ(problems_of(nodes, false),
              Words{"node 1 does not contain the volume of node 4, by 0.25"});
    nodes[1].volume = NodeVolume{};
    EXPECT_EQ(problems_of(nodes), Words{"node 1 has no volume"});
    // That none has any is no problem.
    for (ToldNode& node : nodes) node.volume = NodeVolume{};
    EXPECT_EQ(problems_of(nodes), Words{});
    // The corners of the box about the triangles below are outside of this ball. The triangles are
    // not.
    nodes = nodes_of_row();
    nodes[3].volume = Ball{Vec3(0.25, 0.25, 0), std::sqrt(0.125) + 1e-12};
    nodes[0].volume = Ball{Vec3(1.75, 0, 0), 1.85};
    EXPECT_EQ(problems_of(nodes), Words{});
    nodes[0].volume = Ball{Vec3(1.75, 0, 0), 1.75};
    EXPECT_EQ(problems_of(nodes).size(), 1u);
}

TEST(TreeCheck, SeveralRootsAreAForest) {
    auto nodes = nodes_of_row();
    nodes[2].children = {};
    nodes[5].parent = nodes[6].parent = no_index;
    EXPECT_EQ(problems_of(nodes), Words{});
}

TEST(TreeCheck, OfWhatANodeDoesNotContainTheFarthestIsTold) {
    auto nodes = nodes_of_row();
    nodes[0].volume = box_of_row(0, 1.75);
    EXPECT_EQ(problems_of(nodes), Words{"node 0 does not contain triangle 3, by 1.25"});
    nodes[0].volume = box_of_row(1.25, 3);
    EXPECT_EQ(problems_of(nodes), Words{"node 0 does not contain triangle 0, by 1.25"});
    nodes[0].volume = box_of_row(0.25, 1.75);
    EXPECT_EQ(problems_of(nodes, false),
              Words{"node 0 does not contain the volume of node 2, by 1.25"});
    nodes[0].volume = box_of_row(1.25, 2.75);
    EXPECT_EQ(problems_of(nodes, false),
              Words{"node 0 does not contain the volume of node 1, by 1.25"});
}

TEST(TreeCheck, OneCornerOfATriangleIsEnough) {
    auto nodes = nodes_of_row();
    // The upper half: the last corner of triangle 0 is inside.
    nodes[3].volume = Obb{Vec3(0.25, 0.375, 0), Mat3::Identity(), Vec3(0.25, 0.125, 0)};
    EXPECT_EQ(problems_of(nodes), Words{"node 3 does not contain triangle 0, by 0.25"});
    // The left half: the first and the last are.
    nodes[3].volume = Obb{Vec3(0.125, 0.25, 0), Mat3::Identity(), Vec3(0.125, 0.25, 0)};
    EXPECT_EQ(problems_of(nodes), Words{"node 3 does not contain triangle 0, by 0.25"});
}

TEST(TreeCheck, WhatIsOutsideByLittleMoreThanTheToleranceIsTold) {
    auto nodes = nodes_of_row();
    nodes[1].volume = box_of_row(0, 0.75);
    for (const bool with_mesh : {true, false}) {
        EXPECT_EQ(problems_of(nodes, with_mesh, 0.249).size(), 1u);
        EXPECT_EQ(problems_of(nodes, with_mesh, 0.01).size(), 1u);
        EXPECT_EQ(problems_of(nodes, with_mesh, 0.251), Words{});
    }
}

/// Of a node of objects, one child, which has an object with this extent, where there is one.
Words words_of_objects(const NodeVolume& parent, const NodeVolume& child,
                       const NodeVolume& extent) {
    EngineNodes tree = tree_of({{0, no_index, {1}, {}, parent}, {1, 0, {}, {0}, child}});
    tree.has_objects = true;
    if (has_volume(extent)) tree.set_object_volume(0, extent);
    Words words;
    for (const TreeProblem& problem : check_volumes(tree, tree_shape(tree, 1), nullptr, 1e-9))
        words.push_back(words_of(problem, tree));
    return words;
}

// A ball has no faces along which one could look.
TEST(TreeCheck, TellsHowFarAnObjectReachesBeyondABall) {
    const auto words = [](const NodeVolume& ball, const NodeVolume& extent) {
        return words_of_objects(ball, Ball{Vec3::Zero(), 100}, extent);
    };
    const Vec3 odd = Vec3(1, 2, 3) / std::sqrt(14.0);
    EXPECT_EQ(words(Ball{Vec3(1, 1, 1), 1}, Ball{Vec3(1, 1, 1) + odd, 0.5}),
              Words{"node 0 does not contain object 0, by 0.5"});
    EXPECT_EQ(words(Ball{Vec3(1, 1, 1), 1}, Ball{Vec3(1, 1, 1) + 0.5 * odd, 0.5}), Words{})
        << "the ball of the child may be larger than its object";
    EXPECT_EQ(words(Ball{Vec3::Zero(), 1}, Obb{Vec3(2, 0, 0), Mat3::Identity(), Vec3(1, 4, 0)}),
              Words{"node 0 does not contain object 0, by 4"});
}

TEST(TreeCheck, WhereExtentsAreNotKnownABoxContainsTheBoxesOfItsChildren) {
    const Obb parent = box_between(Vec3::Zero(), Vec3::Ones()),
              child = box_between(Vec3::Zero(), Vec3(1, 1, 2));
    EXPECT_EQ(words_of_objects(parent, child, {}),
              Words{"node 0 does not contain the volume of node 1, by 1"});
    EXPECT_EQ(words_of_objects(parent, child, parent), Words{});
    // A ball about objects need not contain the balls about these.
    EXPECT_EQ(words_of_objects(Ball{Vec3::Zero(), 1}, Ball{Vec3(0, 0, 1), 1}, {}), Words{});
}

TEST(TreeCheck, CountsTheLeavesWhoseExtentsAreNotKnown) {
    const Obb box = box_between(Vec3::Zero(), Vec3::Ones());
    EngineNodes tree =
        tree_of({{0, no_index, {1, 2}, {}, box}, {1, 0, {}, {0}, box}, {2, 0, {}, {1, 2}, box}});
    tree.has_objects = true;
    for (const std::uint32_t object : {0u, 1u}) tree.set_object_volume(object, box);
    UnjudgedVolumes unjudged;
    check_volumes(tree, tree_shape(tree, 3), nullptr, 1e-9, &unjudged);
    EXPECT_EQ(unjudged.of_leaves, 2u);
    EXPECT_EQ(unjudged.leaves, 1u);
    tree.set_object_volume(2, box);
    unjudged = {};
    check_volumes(tree, tree_shape(tree, 3), nullptr, 1e-9, &unjudged);
    EXPECT_EQ(unjudged.leaves, 0u);
}

TEST(TreeCheck, ALeafWithoutItemsNeedsNoVolume) {
    auto nodes = nodes_of_row();
    nodes.push_back({7, 2, {}, {}, {}});
    nodes[2].children.push_back(7);
    EXPECT_EQ(problems_of(nodes), Words{});
    nodes.back().items = {3};
    nodes[6].items = {};
    EXPECT_EQ(problems_of(nodes), Words{"node 7 has no volume"});
}

TEST(TreeCheck, ANodeAboveOneThatMissesATriangleInheritsThat) {
    auto nodes = nodes_of_row();
    nodes[3].volume = box_of_row(0, -0.5);
    nodes[1].volume = box_of_row(0, -0.25);
    const Mesh mesh = row_of_triangles();
    const EngineNodes tree = tree_of(nodes);
    const auto problems = check_volumes(tree, tree_shape(tree, 4), &mesh, 1e-9);
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[0].node, 3u);
    EXPECT_FALSE(problems[0].inherited);
    EXPECT_EQ(problems[1].node, 1u);
    EXPECT_EQ(problems[1].inherited, false) << "triangle 1 is in its leaf";
    nodes[1].volume = Obb{Vec3(1, 0.25, 0), Mat3::Identity(), Vec3(0.75, 0.25, 0)};
    const EngineNodes above = tree_of(nodes);
    const auto inherited = check_volumes(above, tree_shape(above, 4), &mesh, 1e-9);
    ASSERT_EQ(inherited.size(), 2u);
    EXPECT_TRUE(inherited[1].inherited);
}

TEST(TreeCheck, TheToleranceOfANodeFollowsItsOwnNumbers) {
    auto nodes = nodes_of_row();
    nodes[3].volume = box_of_row(0, -0.125);
    EngineNodes tree = tree_of(nodes);
    tree[0].reach = 1e13;
    const Mesh mesh = row_of_triangles();
    const auto found = [&] {
        return check_volumes(tree, tree_shape(tree, 4), &mesh, NodeTolerance(1e-9, 1e-6)).size();
    };
    EXPECT_EQ(found(), 1u) << "the root is huge, and the leaf is not";
    tree[3].reach = 1e6;
    EXPECT_EQ(found(), 0u);
}

TEST(TreeCheck, ABoxThatMissesALittleWithinTheToleranceIsCounted) {
    auto nodes = nodes_of_row();
    nodes[3].volume = box_of_row(0, -1e-5);
    EngineNodes tree = tree_of(nodes);
    for (std::uint32_t i = 0; i < tree.size(); ++i) tree[i].reach = 4;
    const Mesh mesh = row_of_triangles();
    UnjudgedVolumes unjudged;
    EXPECT_TRUE(check_volumes(tree, tree_shape(tree, 4), &mesh, 1e-4, &unjudged).empty());
    EXPECT_EQ(unjudged.slightly_open, 1u);
    EXPECT_NEAR(unjudged.open_by, 1e-5, 1e-9);
    // By less than a unit of 32-bit numbers, 4.8e-7 here.
    tree.set_volume(3, box_of_row(0, -4e-7), 0, "", 4);
    check_volumes(tree, tree_shape(tree, 4), &mesh, 1e-4, &unjudged);
    EXPECT_EQ(unjudged.slightly_open, 0u);
}

TEST(TreeCheck, ATriangleWithoutAreaMayBeInNoLeaf) {
    auto nodes = nodes_of_row();
    nodes[6].items = {};
    Mesh mesh = row_of_triangles();
    const EngineNodes tree = tree_of(nodes);
    const TreeShape shape = tree_shape(tree, 4);
    EXPECT_EQ(check_shape(tree, shape, &mesh).size(), 1u);
    mesh.vertices[mesh.triangles[3][2]] = mesh.vertices[mesh.triangles[3][1]];
    EXPECT_EQ(check_shape(tree, shape, &mesh).size(), 0u);
    UnjudgedVolumes unjudged;
    check_volumes(tree, shape, &mesh, 1e-9, &unjudged);
    EXPECT_EQ(unjudged.dropped, 1u);
}

}  // namespace
}  // namespace scb
