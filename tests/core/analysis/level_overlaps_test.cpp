#include "core/analysis/level_overlaps.h"

#include <gtest/gtest.h>

#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

std::vector<std::size_t> overlaps(const AnyHierarchy& any, const Pose& b_to_a,
                                  const OverlapOptions& test, std::size_t most) {
    const TreeShape shape = tree_shape(topology_of(any));
    return level_overlaps(any, shape, any, shape, b_to_a, test, most);
}

TEST(LevelOverlaps, AreThoseOfAllPairsOfTheLevel) {
    const BuiltMesh mesh(height_field(9));
    const AnyHierarchy& any = mesh.hierarchies[static_cast<std::size_t>(VolumeKind::scb)];
    const auto& hierarchy = std::get<Hierarchy<Scb>>(any);
    const TreeShape shape = tree_shape(*hierarchy.topology);
    Pose apart = pose_to_divide();
    apart.rotation << 1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8;
    // Apart, though not by their roots.
    while (overlaps(any, apart, {}, SIZE_MAX).back() > 0) apart.translation[2] += 0.001;
    for (const Pose& b_to_a : {pose_to_divide(), apart}) {
        const Placement placed = query_placement(hierarchy, hierarchy, b_to_a);
        const std::vector<std::size_t> counts = overlaps(any, b_to_a, {}, SIZE_MAX);
        ASSERT_EQ(counts[0], 1U);
        // Node by node up to the roots, one level above the other.
        const auto above = [&](std::uint32_t node, int level) {
            while (static_cast<int>(shape.depths[node]) > level) node = shape.parents[node];
            return node;
        };
        for (int level = 0; level < static_cast<int>(counts.size()); ++level) {
            std::size_t expected = 0;
            for (const std::uint32_t x : level_cover(shape, level))
                for (const std::uint32_t y : level_cover(shape, level)) {
                    bool all = true;
                    for (int up = 0; up <= level && all; ++up)
                        all = ScbTest<OverlapTest::symmetric>{OverlapOptions{}.threshold}(
                                  hierarchy.volumes[above(x, up)], hierarchy.volumes[above(y, up)],
                                  placed) == Stage::overlapping;
                    expected += all ? 1 : 0;
                }
            EXPECT_EQ(counts[static_cast<std::size_t>(level)], expected) << level;
        }
        // A level of none shows the gap; what meets has pairs on all levels.
        const bool meet =
            !collide(any, mesh.mesh, any, mesh.mesh, b_to_a, CollideOptions{}).pairs.empty();
        EXPECT_EQ(counts.back() > 0, meet);
        EXPECT_GT(counts.size(), 3U);
        EXPECT_TRUE(!meet || counts.size() == static_cast<std::size_t>(depth(shape)) + 1);
    }
}

TEST(LevelOverlaps, EndBeforeTheFirstLevelOfMoreThanTheMost) {
    const BuiltMesh mesh(height_field(9));
    const AnyHierarchy& any = mesh.hierarchies[static_cast<std::size_t>(VolumeKind::ball)];
    const std::vector<std::size_t> all = overlaps(any, pose_to_divide(), {}, SIZE_MAX);
    ASSERT_GT(all.size(), 5U);
    for (const std::size_t most : {std::size_t{0}, all[2], all[3] - 1, all[4]}) {
        std::vector<std::size_t> expected = all;
        for (std::size_t i = 0; i < expected.size(); ++i)
            if (expected[i] > most) expected.resize(i);
        EXPECT_EQ(overlaps(any, pose_to_divide(), {}, most), expected) << most;
    }
}

/// A root and so many leaves.
TreeShape star(std::uint32_t leaves) {
    TreeShape shape;
    shape.roots = {0};
    for (std::uint32_t node = 0; node <= leaves; ++node) {
        shape.parents.push_back(node == 0 ? no_index : 0);
        shape.depths.push_back(node == 0 ? 0 : 1);
        shape.first_child.push_back(node == 0 ? 1 : no_index);
        shape.next_sibling.push_back(node == 0 || node == leaves ? no_index : node + 1);
        shape.order.push_back(node);
    }
    return shape;
}

TEST(LevelOverlaps, EndBeforeALevelOfEndlessTests) {
    // Other engines' trees may have any number of children, and of roots.
    TreeShape wide = star(1'000'000), roots;
    roots.roots.resize(1'000'000);
    std::size_t tests = 0;
    const auto apart = [&](std::uint32_t x, std::uint32_t y) {
        ++tests;
        return x == 0 && y == 0 && tests == 1;
    };
    EXPECT_EQ(level_overlaps(wide, wide, apart, 1000), std::vector<std::size_t>{1});
    EXPECT_EQ(level_overlaps(roots, roots, apart, 1000), std::vector<std::size_t>{});
    EXPECT_LE(tests, 2U * 64 * 1000 + 1);
    // So many on each level, not on all together.
    TreeShape chain;
    chain.roots = {0};
    for (std::uint32_t node = 0; node < 100; ++node) {
        chain.parents.push_back(node == 0 ? no_index : node - 1);
        chain.depths.push_back(node);
        chain.first_child.push_back(node == 99 ? no_index : node + 1);
        chain.next_sibling.push_back(no_index);
        chain.order.push_back(node);
    }
    EXPECT_EQ(level_overlaps(
                  chain, chain, [](auto, auto) { return true; }, 1),
              std::vector<std::size_t>(100, 1));
    // Few are counted to the end.
    EXPECT_EQ(level_overlaps(
                  star(5), star(7), [](auto, auto) { return true; }, 1000),
              (std::vector<std::size_t>{1, 35}));
}

}  // namespace
}  // namespace scb
