#include "scenes/scene/scene_hierarchies.h"

#include <gtest/gtest.h>

#include "scb/level_cover.h"
#include "tests/core/fit/point_sets.h"

namespace scb::scenes {
namespace {

TEST(TellingLevels, EndWhereHardlyAnyLeafIsDeeper) {
    // Dense in the middle, so that some leaves are far deeper than others.
    Mesh mesh = random_soup(3, 500, 0.1);
    for (Vec3& v : mesh.vertices) v *= squared_norm(v) * squared_norm(v);
    std::vector<MeshTopology> topologies;
    topologies.push_back(mesh_topology(mesh));
    const std::vector<int> levels = telling_levels(topologies);
    ASSERT_GT(levels.size(), 3u);
    const int last = deepest(topologies);
    EXPECT_EQ(levels.back(), last);
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) EXPECT_EQ(levels[i], static_cast<int>(i));

    const Topology& topology = *topologies[0].topology;
    const std::vector<std::uint16_t> depths = node_depths(topology);
    const auto leaves_to = [&](int level) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < depths.size(); ++i)
            count += topology.nodes[i].is_leaf() && depths[i] <= level;
        return count;
    };
    const int first = levels[levels.size() - 2];
    ASSERT_LT(first, last - 1) << "nothing is left out";
    EXPECT_GE(leaves_to(first), 475u);
    EXPECT_LT(leaves_to(first - 1), 475u);
}

TEST(TellingLevels, AreAllOfAShallowHierarchy) {
    std::vector<MeshTopology> topologies;
    const Mesh one = random_soup(1, 1, 0.1), four = random_soup(1, 4, 0.1);
    topologies.push_back(mesh_topology(one));
    EXPECT_EQ(telling_levels(topologies), std::vector<int>{0});
    topologies.push_back(mesh_topology(four));
    EXPECT_EQ(telling_levels(topologies).front(), 0);
    EXPECT_EQ(telling_levels(topologies).back(), deepest(topologies));
}

}  // namespace
}  // namespace scb::scenes
