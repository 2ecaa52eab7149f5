#include "core/hierarchy/sah_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scb/any_packed.h"
#include "scb/level_cover.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

Topology by_cost(const Mesh& mesh) { return build_topology(mesh, {.split = SplitMethod::cost}); }

// What a query is thought to take: squared sums of the sides of all nodes' boxes.
double cost_of(const Topology& topology, const Mesh& mesh) {
    double sum = 0;
    for (const TopologyNode& node : topology.nodes) {
        Box box;
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            for (const std::uint32_t v : mesh.triangles[topology.order[k]])
                box.add(mesh.vertices[v]);
        const double sides = (box.upper - box.lower).sum();
        sum += sides * sides;
    }
    return sum;
}

TEST(SahSplit, IsValidForEveryKindOfMesh) {
    std::vector<Mesh> meshes;
    for (const int count : {1, 2, 3, 4, 9, 10, 15, 16, 17, 100, 3000})
        meshes.push_back(random_soup(41, count, 0.2));
    Mesh same{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    same.triangles.assign(5000, {0, 1, 2});
    meshes.push_back(same);
    Mesh point{{{1, 1, 1}}, {}};
    point.triangles.assign(100, {0, 0, 0});
    meshes.push_back(point);
    Mesh thin = height_field(30);  // so thin that 32 over its width is infinite
    for (Vec3& v : thin.vertices) v[2] *= 1e-310;
    meshes.push_back(thin);
    for (const Mesh& mesh : meshes) {
        const Topology topology = by_cost(mesh);
        EXPECT_EQ(validate(topology, mesh), "");
        // A tenth in each half, and fewer than ten may come off one by one.
        EXPECT_LE(depth(topology),
                  14 + std::log(static_cast<double>(mesh.triangles.size())) / std::log(10.0 / 9.0));
    }
}

TEST(SahSplit, FallsBackToTheRulesOfThePaper) {
    Mesh same{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    same.triangles.assign(100, {0, 1, 2});
    const Topology topology = by_cost(same);
    EXPECT_EQ(topology.rules[0], SplitRule::index);
    EXPECT_LE(depth(topology), 11);
}

TEST(SahSplit, CostsLessThanTheRulesOfThePaper) {
    for (const Mesh& mesh : {height_field(40), random_soup(43, 2000, 0.05)})
        EXPECT_LT(cost_of(by_cost(mesh), mesh), 0.99 * cost_of(build_topology(mesh), mesh));
}

TEST(SahSplit, TriesEveryDivisionOfAFew) {
    // Two clusters, of 3 and 9 triangles, along y.
    Mesh mesh = random_soup(44, 12, 0.1);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v] = 0.1 * mesh.vertices[v] + Vec3(0, v < 9 ? 0 : 10, 0);
    const Topology topology = by_cost(mesh);
    EXPECT_EQ(topology.rules[0], SplitRule::least_cost);
    EXPECT_EQ(topology.nodes[1].count, 3u);
}

TEST(SahSplit, IsTheSameForAnyNumberOfThreads) {
    const Mesh mesh = height_field(100);
    const Topology one = by_cost(mesh);
    const Topology three = build_topology(mesh, {.split = SplitMethod::cost, .threads = 3});
    EXPECT_EQ(one.order, three.order);
    EXPECT_EQ(one.rules, three.rules);
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
        ASSERT_EQ(one.nodes[i].left, three.nodes[i].left) << i;
}

TEST(SahSplit, IsTheSameWithAnyVectorInstructions) {
    std::vector<Mesh> meshes = {height_field(40), random_soup(45, 3000, 0.05)};
    for (int count = 2; count <= 40; ++count) meshes.push_back(random_soup(46, count, 0.3));
    Mesh twice = random_soup(47, 30, 0.1);  // centroids that are equal
    for (std::size_t t = 0; t < 30; ++t) twice.triangles.push_back(twice.triangles[t]);
    meshes.push_back(twice);
    for (const Mesh& mesh : meshes)
        for (const SimdLevel level : available_simd_levels()) {
            const Topology best = by_cost(mesh);
            const Topology other =
                build_topology(mesh, {.split = SplitMethod::cost, .simd = level});
            ASSERT_EQ(best.order, other.order) << simd_level_name(level);
            ASSERT_EQ(best.rules, other.rules) << simd_level_name(level);
        }
}

TEST(SahSplit, QueriesFindTheSamePairs) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const SmallScene scene = small_scene(seed);
        const std::vector<IndexPair> expected = brute_force(scene.a.mesh, scene.b.mesh, scene.pose);
        const BuildOptions options{.split = SplitMethod::cost};
        const auto a = build_hierarchy<Scb>(scene.a.mesh, options),
                   b = build_hierarchy<Scb>(scene.b.mesh, options);
        EXPECT_EQ(collide<Scb>({a, scene.a.mesh}, {b, scene.b.mesh}, scene.pose).pairs, expected);
        const PackedLayout layout = *packed_layout_of("indexed8");
        EXPECT_EQ(collide_packed(pack_any(layout, a, scene.a.mesh), scene.a.mesh,
                                 pack_any(layout, b, scene.b.mesh), scene.b.mesh, scene.pose)
                      .pairs,
                  expected)
            << seed;
    }
}

}  // namespace
}  // namespace scb
