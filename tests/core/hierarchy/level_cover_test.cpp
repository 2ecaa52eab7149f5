#include "scb/level_cover.h"

#include <gtest/gtest.h>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/model/level_statistics.h"
#include "scb/any_hierarchy.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(LevelCover, HoldsEveryTriangleOnceAtEveryLevel) {
    const Mesh mesh = random_soup(71, 300, 0.2);
    const Topology topology = build_topology(mesh);
    const int deepest = depth(topology);
    const TreeShape shape = tree_shape(topology);
    EXPECT_EQ(depth(shape), deepest);
    for (int level = leaf_level; level <= deepest + 2; ++level) {
        EXPECT_EQ(level_cover(shape, level), level_cover(topology, level)) << level;
        std::uint32_t next = 0, triangles = 0;
        for (const std::uint32_t node : level_cover(topology, level)) {
            EXPECT_GE(node, next);  // in the order of the nodes
            next = node + 1;
            triangles += topology.nodes[node].count;
        }
        EXPECT_EQ(triangles, 300u) << level;
    }
    EXPECT_EQ(level_cover(topology, 0), std::vector<std::uint32_t>{0});
    EXPECT_EQ(level_cover(topology, leaf_level).size(), 300u);
    EXPECT_EQ(level_cover(topology, deepest), level_cover(topology, leaf_level));
}

TEST(LevelCover, StatisticsAreThoseOfTheLevelWhereItHasNoLeavesAbove) {
    const auto h = build_hierarchy<Scb>(height_field(16));
    const LevelStatistics level = level_statistics(h)[4];
    const AnyHierarchy any = h;
    const VolumeStatistics cover = cover_statistics(Tree(any), level_cover(*h.topology, 4));
    EXPECT_EQ(cover.volumes, level.volumes);
    EXPECT_DOUBLE_EQ(cover.mean_diameter(), level.mean_diameter());
    EXPECT_DOUBLE_EQ(cover.mean_thickness(), level.mean_thickness());
    EXPECT_DOUBLE_EQ(cover.area, level.area);
    EXPECT_DOUBLE_EQ(cover.volume, level.volume);
    const std::vector<LevelStatistics> levels = level_statistics(h);
    for (std::size_t k = 0; k < levels.size(); ++k)
        EXPECT_EQ(levels[k].cover, level_cover(*h.topology, static_cast<int>(k)).size());
}

TEST(AnyHierarchy, NamesAndFitsEveryKind) {
    const Mesh mesh = random_soup(72, 50, 0.3);
    const auto topology = std::make_shared<const Topology>(build_topology(mesh));
    const LeafOrder points = leaf_order(mesh, *topology);
    for (const VolumeKind kind : all_volume_kinds()) {
        EXPECT_EQ(volume_kind_of(volume_kind_name(kind)), kind);
        EXPECT_EQ(validate(fit_any(kind, topology, points), mesh), "");
    }
    EXPECT_FALSE(volume_kind_of("cube"));
}

}  // namespace
}  // namespace scb
