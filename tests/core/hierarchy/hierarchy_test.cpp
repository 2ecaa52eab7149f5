#include "scb/hierarchy.h"

#include <gtest/gtest.h>

#include <cstring>

#include <algorithm>
#include <set>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/model/level_statistics.h"
#include "scb/error.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

template <class V>
class HierarchyOf : public testing::Test {};
using Volumes = testing::Types<Scb, Scb2, Ball, Obb, Aabb, ExactAabb>;
TYPED_TEST_SUITE(HierarchyOf, Volumes);

std::vector<Mesh> all_kinds() {
    std::vector<Mesh> meshes = assorted_meshes(51, {1, 2, 3, 7, 8, 9, 26, 27, 300});
    Mesh segments = random_soup(52, 40, 0.3);
    for (Triangle& t : segments.triangles) t[2] = t[1];
    meshes.push_back(segments);
    return meshes;
}

TYPED_TEST(HierarchyOf, EveryKindOfMeshIsValid) {
    for (const Mesh& mesh : all_kinds())
        EXPECT_EQ(validate(build_hierarchy<TypeParam>(mesh), mesh), "");
    for (const Mesh& mesh : all_kinds())
        EXPECT_EQ(
            validate(build_hierarchy<TypeParam>(mesh, {.fit = {.growth = BallGrowth::radius,
                                                               .ball_method = BallMethod::ritter,
                                                               .margin = 0.01}}),
                     mesh),
            "");
}

TYPED_TEST(HierarchyOf, UnusedVerticesDoNotGrowBounds) {
    Mesh mesh = height_field(4);
    const double size = diameter(build_hierarchy<TypeParam>(mesh).volumes[0]);
    mesh.vertices.emplace_back(100, 100, 100);
    mesh.vertices.emplace_back(std::nan(""), 0, 0);
    EXPECT_EQ(diameter(build_hierarchy<TypeParam>(mesh).volumes[0]), size);
}

TYPED_TEST(HierarchyOf, ValidateFindsAVolumeThatIsTooSmall) {
    const Mesh mesh = random_soup(53, 30, 0.3);
    Hierarchy<TypeParam> h = build_hierarchy<TypeParam>(mesh);
    h.volumes[7] = TypeParam{};
    EXPECT_NE(validate(h, mesh).find("outside the volume of node 7"), std::string::npos);
}

TYPED_TEST(HierarchyOf, LevelStatisticsAddUp) {
    const Mesh mesh = height_field(16);
    const auto h = build_hierarchy<TypeParam>(mesh);
    const std::vector<LevelStatistics> levels = level_statistics(h);
    std::size_t nodes = 0, leaves = 0;
    for (const LevelStatistics& level : levels) {
        nodes += level.volumes;
        leaves += level.leaves;
        EXPECT_LE(level.mean_diameter(), level.max_diameter * (1 + 1e-15));
        EXPECT_EQ(level.leaves, level.rules[0]);
        std::size_t by_rule = 0;
        for (const std::uint32_t n : level.rules) by_rule += n;
        EXPECT_EQ(by_rule, level.volumes);
    }
    EXPECT_EQ(nodes, 2 * mesh.triangles.size() - 1);
    EXPECT_EQ(leaves, mesh.triangles.size());
    EXPECT_EQ(levels[0].volumes, 1u);
    EXPECT_DOUBLE_EQ(levels[0].area, surface_area(h.volumes[0]));
}

TYPED_TEST(HierarchyOf, RefusesABadMeshByName) {
    Mesh mesh = height_field(2);
    mesh.triangles[3][1] = 1000;
    try {
        build_hierarchy<TypeParam>(mesh, {}, "broken.obj");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("broken.obj: triangle 3 names vertex 1000"),
                  std::string::npos);
    }
}

// Bottom up, from the children's DOPs and shared points, must give what fitting the node's distinct
// points directly gives.
TEST(FitVolumes, EqualsFittingEachNodeByItself) {
    for (const Mesh& mesh : {height_field(12), random_soup(54, 200, 0.3)}) {
        const Topology topology = build_topology(mesh);
        const LeafOrder points = leaf_order(mesh, topology);
        for (const BallGrowth growth : {BallGrowth::radius, BallGrowth::ritter}) {
            const FitOptions options{.growth = growth};
            const std::vector<Scb> volumes = fit_volumes<Scb>(topology, points, options);
            for (std::size_t i = 0; i < volumes.size(); ++i) {
                const TopologyNode& node = topology.nodes[i];
                std::set<std::uint32_t> ids;
                for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                    ids.insert(points.corners[k].begin(), points.corners[k].end());
                std::vector<Vec3> own;
                for (const std::uint32_t id : ids) own.push_back(points.points.view()[id]);
                const Scb direct = fit_scb(own, options);
                ASSERT_EQ(volumes[i].c, direct.c) << i;
                ASSERT_EQ(volumes[i].r, direct.r) << i;
                ASSERT_EQ(volumes[i].n, direct.n) << i;
                ASSERT_EQ(volumes[i].e, direct.e) << i;
                ASSERT_EQ(volumes[i].f, direct.f) << i;
            }
        }
    }
}

TEST(FitVolumes, CountsTheSameWorkForAnyNumberOfThreads) {
    const Mesh mesh = height_field(80);
    const auto counted = [&](int threads) {
        FitCounts counts;
        build_hierarchy<Scb>(mesh, {.fit = {.counts = &counts}, .threads = threads});
        return counts;
    };
    const FitCounts one = counted(1);
    EXPECT_GT(one.point_visits, mesh.triangles.size());
    EXPECT_GT(one.candidate_slabs, mesh.triangles.size());
    for (const int threads : {2, 5}) {
        EXPECT_EQ(counted(threads).point_visits, one.point_visits);
        EXPECT_EQ(counted(threads).candidate_slabs, one.candidate_slabs);
    }
}

#ifdef SCB_SANITIZED
constexpr int thread_counts[] = {5};
#else
constexpr int thread_counts[] = {1, 2, 5};
#endif

TYPED_TEST(HierarchyOf, IsTheSameForAnyThreadsAndVectorInstructions) {
    // Large enough for several threads, and flat enough for many ties.
    for (const Mesh& mesh : {height_field(80), random_soup(62, 10000, 0.1)}) {
        const auto one = build_hierarchy<TypeParam>(mesh);
        for (const SimdLevel level : available_simd_levels())
            for (const int threads : thread_counts) {
                SCOPED_TRACE(simd_level_name(level));
                const auto other =
                    build_hierarchy<TypeParam>(mesh, {.fit = {.simd = level}, .threads = threads});
                ASSERT_EQ(one.topology->order, other.topology->order);
                ASSERT_EQ(one.topology->rules, other.topology->rules);
                ASSERT_EQ(one.volumes.size(), other.volumes.size());
                for (std::size_t i = 0; i < one.volumes.size(); ++i) {
                    ASSERT_EQ(one.topology->nodes[i].left, other.topology->nodes[i].left);
                    ASSERT_EQ(one.topology->nodes[i].count, other.topology->nodes[i].count);
                    ASSERT_EQ(
                        std::memcmp(&one.volumes[i], &other.volumes[i], sizeof one.volumes[i]), 0)
                        << "node " << i << ", threads " << threads;
                }
            }
    }
}

TYPED_TEST(HierarchyOf, LeavesOutTheVolumesOfDeeperNodes) {
    const Mesh mesh = height_field(70);  // more than a thread takes at a time
    const Topology topology = build_topology(mesh);
    const LeafOrder points = leaf_order(mesh, topology);
    const auto all = fit_volumes<TypeParam>(topology, points);
    const std::vector<std::uint16_t> depths = node_depths(topology);
    const auto bytes = [](const TypeParam& volume) {
        return std::string(reinterpret_cast<const char*>(&volume), sizeof volume);
    };
    for (const int threads : {1, 3})
        for (const int deepest : {0, 3, 12}) {
            const auto some =
                fit_volumes<TypeParam>(topology, points, {}, threads, {.deepest = deepest});
            for (std::size_t i = 0; i < all.size(); ++i)
                ASSERT_EQ(bytes(some[i]), bytes(depths[i] <= deepest ? all[i] : TypeParam{})) << i;
        }
}

TEST(FitVolumes, ASoupAndAnIndexedMeshHaveTheSameVolumes) {
    const Mesh indexed = height_field(10);
    Mesh soup;
    for (const Triangle& t : indexed.triangles) {
        const auto v = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t corner : t) soup.vertices.push_back(indexed.vertices[corner]);
        soup.triangles.push_back({v, v + 1, v + 2});
    }
    const auto a = build_hierarchy<Scb>(indexed), b = build_hierarchy<Scb>(soup);
    ASSERT_EQ(a.volumes.size(), b.volumes.size());
    for (std::size_t i = 0; i < a.volumes.size(); ++i) {
        EXPECT_EQ(a.volumes[i].c, b.volumes[i].c);
        EXPECT_EQ(a.volumes[i].n, b.volumes[i].n);
        EXPECT_EQ(a.volumes[i].e, b.volumes[i].e);
    }
}

TEST(ScbHierarchy, ThicknessShrinksFasterThanDiameterOnASmoothSurface) {
    // Section 3.1: per level of a smooth surface the diameter halves every other level, the
    // thickness shrinks as its square.
    Mesh mesh;
    constexpr int n = 128;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
            mesh.vertices.emplace_back(x, y, 0.25 * (x * x + y * y));
        }
    mesh.triangles = grid_triangles(n);
    const std::vector<LevelStatistics> levels = level_statistics(build_hierarchy<Scb>(mesh));
    const double diameters = levels[10].mean_diameter() / levels[4].mean_diameter();
    const double thicknesses = levels[10].mean_thickness() / levels[4].mean_thickness();
    EXPECT_NEAR(diameters, 1.0 / 8, 0.02);
    EXPECT_NEAR(thicknesses, 1.0 / 64, 0.01);
}

}  // namespace
}  // namespace scb
