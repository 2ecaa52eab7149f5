#include "tests/peers/comparison_group.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

SceneComparison compared(const char* scene, std::size_t extra_of_second_peer = 0) {
    SceneComparison result;
    result.scene = scene;
    result.peers.resize(2);
    result.peers[1].difference.extra.count = extra_of_second_peer;
    return result;
}

std::vector<std::string> names(const ComparisonGroup& group) {
    std::vector<std::string> result;
    for (const SceneComparison& scene : group.scenes) result.push_back(scene.scene);
    return result;
}

TEST(ComparisonGroups, KeepCadScenesFromOthers) {
    std::vector<ComparisonGroup> groups;
    for (const char* scene : {"horses", "tube", "dragons", "tube-aligned", "anchor", "my-scene"})
        add_to_group(groups, compared(scene));
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[0].title, "");
    EXPECT_EQ(names(groups[0]), (std::vector<std::string>{"horses", "dragons", "my-scene"}));
    EXPECT_EQ(groups[1].title, "CAD models");
    EXPECT_EQ(names(groups[1]), (std::vector<std::string>{"tube", "anchor"}));
    EXPECT_EQ(names(groups[2]), std::vector<std::string>{"tube-aligned"});
}

TEST(ComparisonGroups, TellWhoFindsOtherPairsInAnyOfThem) {
    std::vector<ComparisonGroup> groups;
    add_to_group(groups, compared("horses"));
    EXPECT_TRUE(finds_the_same(groups, 0));
    EXPECT_TRUE(finds_the_same(groups, 1));
    add_to_group(groups, compared("tube", 3));
    EXPECT_TRUE(finds_the_same(groups, 0));
    EXPECT_FALSE(finds_the_same(groups, 1));
}

}  // namespace
}  // namespace scb
