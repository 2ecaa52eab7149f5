#include "core/model/tree.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_tree.h"

namespace scb {
namespace {

Tree tree_with(const std::vector<ToldNode>& nodes) {
    EngineNodes recorded = tree_of(nodes);
    TreeShape shape = tree_shape(recorded, 4);
    return {std::move(recorded), std::move(shape)};
}

const Mat3 turned = (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();

TEST(EngineTree, IsOfAFamilyWhereAllItsVolumesAre) {
    auto nodes = nodes_of_row();
    EXPECT_EQ(tree_with(nodes).family(), VolumeFamily::box);
    nodes[0].volume = nodes[6].volume = NodeVolume{};
    EXPECT_EQ(tree_with(nodes).family(), VolumeFamily::box);
    nodes[6].volume = Ball{};
    EXPECT_EQ(tree_with(nodes).family(), VolumeFamily::convex);
    nodes[6].volume = box_of_row(3, 3);
    nodes[1].volume = Ball{};
    EXPECT_EQ(tree_with(nodes).family(), VolumeFamily::convex);
    const std::pair<NodeVolume, VolumeFamily> kinds[] = {{Ball{}, VolumeFamily::ball},
                                                         {Scb{}, VolumeFamily::slab_cut},
                                                         {Scb2{}, VolumeFamily::two_slabs},
                                                         {Capsule{}, VolumeFamily::convex},
                                                         {NodeVolume{}, VolumeFamily::convex}};
    for (const auto& [volume, family] : kinds) {
        for (ToldNode& node : nodes) node.volume = volume;
        EXPECT_EQ(tree_with(nodes).family(), family);
    }
}

TEST(EngineTree, ContainsWhatIsInsideOfAVolumeGrownByTheSlack) {
    const auto tree = tree_with(nodes_of_row());
    const Vec3 beside(0.75, 0.25, 0);  // a quarter beside the box of triangle 0
    EXPECT_TRUE(tree.contains(1, beside, 0));
    EXPECT_FALSE(tree.contains(3, beside, 0));
    EXPECT_FALSE(tree.contains(3, beside, 0.2));
    EXPECT_TRUE(tree.contains(3, beside, 0.25));
    EXPECT_TRUE(tree.contains(3, Vec3(0.5, 0.5, 0), 0)) << "a corner";
}

TEST(EngineTree, HasTheNumbersItemsAndVolumesThatWereTold) {
    auto nodes = nodes_of_row();
    nodes[6].number = 60;
    nodes[2].children = {5, 60};
    nodes[1].volume = NodeVolume{};
    const auto tree = tree_with(nodes);
    EXPECT_EQ(tree.number(6), 60u);
    EXPECT_EQ(tree.node_of(60), 6u);
    EXPECT_EQ(tree.node_of(6), no_index);
    EXPECT_EQ(tree.items(6)[0], 3u);
    EXPECT_FALSE(tree.has_volume(1));
    EXPECT_TRUE(tree.has_volume(2));
    EXPECT_EQ(tree.volume_size(0).area, 2 * 3.5 * 0.5);
    EXPECT_EQ(tree.volume_size(1).area, 0);
}

TEST(TreeHash, TellsWhatHangsWhereAndHoldsWhichItems) {
    const auto hash = [](const std::vector<ToldNode>& nodes) { return tree_with(nodes).hash(); };
    const std::uint64_t valid = hash(nodes_of_row());
    auto nodes = nodes_of_row();
    nodes[3].volume = Ball{};
    EXPECT_EQ(hash(nodes), valid);
    nodes = nodes_of_row();
    std::swap(nodes[3].items, nodes[4].items);
    EXPECT_NE(hash(nodes), valid);
    nodes = nodes_of_row();
    nodes[1].children = {3, 5};
    nodes[2].children = {4, 6};
    nodes[4].parent = 2;
    nodes[5].parent = 1;
    EXPECT_NE(hash(nodes), valid);
}

TEST(VolumesTitles, NameEachTypeOnce) {
    const auto titles = [](const std::vector<NodeVolume>& volumes) {
        std::vector<ToldNode> nodes;
        for (const NodeVolume& volume : volumes)
            nodes.push_back({static_cast<std::uint32_t>(nodes.size()), no_index, {}, {}, volume});
        return volumes_titles(tree_of(nodes));
    };
    using Titles = std::vector<std::string>;
    const Obb aligned = box_of_row(0, 1), oriented{Vec3::Zero(), turned, Vec3(1, 1, 1)};
    EXPECT_EQ(titles({NodeVolume{}}), Titles{});
    EXPECT_EQ(titles({aligned, NodeVolume{}, aligned}), Titles{"AABB"});
    EXPECT_EQ(titles({aligned, oriented, aligned}), Titles{"OBB"})
        << "an oriented box may have its body's axes";
    EXPECT_EQ(titles({Ball{}, Capsule{}, Ball{}, Rss{}, Scb{}, Scb2{}}),
              (Titles{"ball", "capsule", "RSS", "SCB", "SCB2"}));
    Polytope hull;
    hull.corners = {Vec3::Zero()};
    Polytope dop = slabs_polytope(std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                  std::vector<double>{0, 1, 0, 1, 0, 1});
    EXPECT_EQ(titles({std::make_shared<const Polytope>(hull)}), Titles{"hull"});
    EXPECT_EQ(titles({std::make_shared<const Polytope>(dop)}), Titles{"k-DOP"});
}

}  // namespace
}  // namespace scb
