#include "render/figures/volume_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scb/hierarchy.h"
#include "tests/core/fit/point_sets.h"

namespace scb::render {
namespace {

TEST(VolumeColors, NamesAreReadBack) {
    for (const ColorBy by : {ColorBy::body, ColorBy::depth, ColorBy::radius, ColorBy::thickness,
                             ColorBy::subtree, ColorBy::surface})
        EXPECT_EQ(color_by_names.find(color_by_names[by]), by);
    EXPECT_FALSE(color_by_names.find("mood"));
}

TEST(VolumeColors, MagnitudesFollowTheirScales) {
    const auto ball = [](double d) { return VolumeLengths{d, d}; };
    const ColorScale depth{ColorBy::depth, 20, 1}, radius{ColorBy::radius, 20, 4},
        thickness{ColorBy::thickness, 20, 1};
    EXPECT_DOUBLE_EQ(color_magnitude(depth, ball(1), 5), 0.25);
    EXPECT_DOUBLE_EQ(color_magnitude(radius, ball(4), 0), 1);
    EXPECT_DOUBLE_EQ(color_magnitude(radius, ball(0.5), 0), 1 - 3.0 / radius_halvings);
    EXPECT_EQ(color_magnitude(radius, ball(1e-9), 0), 0);
    EXPECT_EQ(color_magnitude(radius, ball(0), 0), 0);
    for (double d = 1e-3; d < 4; d *= 1.07)
        EXPECT_NEAR(color_magnitude(radius, ball(d), 0), 1 + std::log2(d / 4) / radius_halvings,
                    1e-15);
    EXPECT_DOUBLE_EQ(color_magnitude(thickness, ball(3), 0), 1);
    EXPECT_DOUBLE_EQ(
        color_magnitude(thickness, lengths_of(Scb{Vec3::Zero(), 1, Vec3::UnitZ(), 0.25, -0.25}), 0),
        0.5);
    EXPECT_EQ(color_magnitude(thickness, lengths_of(Scb{}), 0), 0);
}

TEST(VolumeColors, AnEqualShareOfTheSurfaceIsInTheMiddle) {
    EXPECT_DOUBLE_EQ(surface_magnitude(1), 0.5);
    EXPECT_DOUBLE_EQ(surface_magnitude(1 << surface_doublings), 1);
    EXPECT_DOUBLE_EQ(surface_magnitude(1.0 / (1 << surface_doublings)), 0);
    EXPECT_GT(surface_magnitude(2), 0.5);
    EXPECT_EQ(surface_magnitude(0), 0);
    // Of a mesh that has no surface.
    EXPECT_EQ(surface_magnitude(std::nan("")), 0);
}

TEST(VolumeColors, BodiesKeepTheirHueAndNeighborsDiffer) {
    const ColorScale scale;
    const VolumeLengths ball{2, 2};
    EXPECT_FALSE(volume_color(scale, ball, 0, 0, 1) == volume_color(scale, ball, 0, 0, 2));
    EXPECT_EQ(volume_color(scale, ball, 0, 0, 1), volume_color(scale, ball, 3, 0, 1));
    const Rgba8 a = volume_color(scale, ball, 0, 0, 7), b = volume_color(scale, ball, 0, 1, 7);
    EXPECT_GT(a.b, a.r);  // blue
    EXPECT_GT(b.r, b.b);  // orange
}

TEST(VolumeColors, LegendsHaveRisingTicks) {
    for (const ColorBy by : {ColorBy::depth, ColorBy::radius, ColorBy::thickness, ColorBy::surface})
        for (const int deepest : {0, 3, 22}) {
            const auto legend = legend_of({by, deepest, 2});
            ASSERT_TRUE(legend);
            for (std::size_t i = 0; i < legend->ticks.size(); ++i) {
                EXPECT_GE(legend->ticks[i].first, i == 0 ? 0 : legend->ticks[i - 1].first + 0.01);
                EXPECT_LE(legend->ticks[i].first, 1);
            }
        }
    EXPECT_FALSE(legend_of({ColorBy::body, 3, 1}));
    EXPECT_FALSE(legend_of({ColorBy::subtree, 3, 1}));
}

TEST(VolumeColors, ASubtreeKeepsItsCategory) {
    const Topology topology = *build_hierarchy<Ball>(random_soup(3, 400, 0.1)).topology;
    const std::vector<std::uint8_t> subtrees = subtrees_of(tree_shape(topology));
    const std::vector<std::uint16_t> depths = node_depths(topology);
    std::vector<std::set<int>> of_level(depths.size());
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        of_level[depths[i]].insert(subtrees[i]);
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf() || depths[i] < 3) continue;
        for (const std::uint32_t child : {node.left, node.left + 1})
            EXPECT_EQ(subtrees[child], subtrees[i]) << i;
    }
    for (std::size_t level = 0; level < 6; ++level)
        EXPECT_EQ(of_level[level].size(), std::size_t{1} << std::min<std::size_t>(level, 3));
    const ColorScale scale{ColorBy::subtree, 0, 1};
    const VolumeLengths ball{2, 2};
    EXPECT_FALSE(volume_color(scale, ball, 0, 2, 7) == volume_color(scale, ball, 0, 3, 7));
}

}  // namespace
}  // namespace scb::render
