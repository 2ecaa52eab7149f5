#include "scb/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scb/hierarchy.h"
#include "scb/level_cover.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

std::array<std::size_t, split_rule_count> rules_of(const Topology& topology) {
    std::array<std::size_t, split_rule_count> counts{};
    for (const SplitRule rule : topology.rules) ++counts[static_cast<std::size_t>(rule)];
    return counts;
}

std::size_t used(const Topology& topology, SplitRule rule) {
    return rules_of(topology)[static_cast<std::size_t>(rule)];
}

// The bound that the 10 : 90 rule guarantees.
int depth_bound(std::size_t triangles) {
    return 4 + static_cast<int>(std::log(static_cast<double>(triangles)) / std::log(10.0 / 9.0));
}

// n tiny triangles at the given positions.
Mesh triangles_at(const std::vector<Vec3>& positions) {
    Mesh mesh;
    for (const Vec3& p : positions) {
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {p, p + Vec3(1e-9, 0, 0), p + Vec3(0, 1e-9, 0)});
        mesh.triangles.push_back({v, v + 1, v + 2});
    }
    return mesh;
}

TEST(BuildTopology, IsValidForEverySmallCount) {
    for (const int count : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 26, 27, 100, 1000}) {
        const Mesh mesh = random_soup(41, count, 0.2);
        const Topology topology = build_topology(mesh);
        EXPECT_EQ(validate(topology, mesh), "");
        EXPECT_LE(depth(topology), depth_bound(mesh.triangles.size()));
    }
}

TEST(BuildTopology, HalvesWhenAllCentroidsAreEqual) {
    for (const int count : {8, 9, 100, 4096, 100000}) {
        Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
        mesh.triangles.assign(static_cast<std::size_t>(count), {0, 1, 2});
        const Topology topology = build_topology(mesh);
        EXPECT_EQ(validate(topology, mesh), "");
        EXPECT_LE(depth(topology), std::ceil(std::log2(count)) + 1);
        EXPECT_GT(used(topology, SplitRule::index), 0u);
    }
}

TEST(BuildTopology, TakesOnePointRepeated) {
    Mesh mesh{{{1, 1, 1}}, {}};
    mesh.triangles.assign(1000, {0, 0, 0});
    const Topology topology = build_topology(mesh);
    EXPECT_EQ(validate(topology, mesh), "");
    EXPECT_LE(depth(topology), 11);
}

TEST(BuildTopology, StaysShallowWhenPositionsAttackTheMiddleSplit) {
    // Each at half the distance of the one before: splitting the box in the middle would peel off
    // one at a time.
    std::vector<Vec3> positions;
    for (int i = 0; i < 1000; ++i)
        positions.emplace_back(std::pow(0.5, i % 500), i < 500 ? 0 : 1e-3, 0);
    const Mesh mesh = triangles_at(positions);
    const Topology topology = build_topology(mesh);
    EXPECT_EQ(validate(topology, mesh), "");
    EXPECT_LE(depth(topology), depth_bound(mesh.triangles.size()));
    EXPECT_GT(used(topology, SplitRule::median_of_7) + used(topology, SplitRule::index), 0u);
}

TEST(BuildTopology, TurnsToTheSecondSideWhenTheLongestFails) {
    // 95 of 100 at one end of x, spread evenly over y.
    std::vector<Vec3> positions;
    for (int i = 0; i < 100; ++i) positions.emplace_back(i < 95 ? 0 : 10, i * 0.05, 0);
    const Topology topology = build_topology(triangles_at(positions));
    EXPECT_EQ(topology.rules[0], SplitRule::second_side);
    EXPECT_NEAR(topology.nodes[1].count, 50, 2);
}

TEST(BuildTopology, TurnsToTheThirdSideThenToTheMedian) {
    std::vector<Vec3> positions, hopeless;
    for (int i = 0; i < 100; ++i) {
        positions.emplace_back(i < 95 ? 0 : 10, i < 4 ? 7 : 0, i * 0.05);
        hopeless.emplace_back(i < 95 ? i * 1e-4 : 10, i < 4 ? 7 : 0, i < 98 ? 0 : 5);
    }
    EXPECT_EQ(build_topology(triangles_at(positions)).rules[0], SplitRule::third_side);
    const Topology topology = build_topology(triangles_at(hopeless));
    EXPECT_EQ(topology.rules[0], SplitRule::median_of_7);
    EXPECT_GE(std::min(topology.nodes[1].count, topology.nodes[2].count), 10u);
}

TEST(BuildTopology, SplitsTheLongestSideOfTheBoxThroughItsMiddle) {
    // Positions along y dominate; the split at the box's middle leaves 30 : 70.
    std::vector<Vec3> positions;
    for (int i = 0; i < 100; ++i) positions.emplace_back(i % 3, i < 30 ? 90 : i * 0.1, 0);
    positions[0][1] = 100;
    const Topology topology = build_topology(triangles_at(positions));
    EXPECT_EQ(topology.rules[0], SplitRule::longest_side);
    EXPECT_EQ(topology.nodes[1].count, 70u);
}

TEST(BuildTopology, SortsBelowEight) {
    const Topology topology =
        build_topology(triangles_at({{5, 0, 0}, {1, 0, 0}, {4, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
    EXPECT_EQ(topology.rules[0], SplitRule::sorted);
    EXPECT_EQ(topology.order, (std::vector<std::uint32_t>{1, 3, 4, 2, 0}));
}

TEST(ValidateTopology, FindsWhatIsWrong) {
    const Mesh mesh = random_soup(42, 20, 0.2);
    const Topology good = build_topology(mesh);
    Topology bad = good;
    bad.order[3] = bad.order[4];
    EXPECT_NE(validate(bad, mesh), "");
    bad = good;
    bad.nodes[1].count -= 1;
    EXPECT_NE(validate(bad, mesh), "");
    bad = good;
    bad.nodes.back().left = 1;
    EXPECT_NE(validate(bad, mesh), "");
}

}  // namespace
}  // namespace scb
