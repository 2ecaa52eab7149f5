#include "scb/collide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scb/level_cover.h"
#include "tests/core/collide/collide_checks.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

TEST(Collide, FindsWhatBruteForceFindsInSmallScenes) {
    std::size_t with_pairs = 0, without = 0;
    for (int i = 0; i < scenes_tried; ++i) {
        SCOPED_TRACE("scene " + std::to_string(i));
        const SmallScene s = small_scene(1000 + static_cast<std::uint64_t>(i));
        expect_queries(s.a, s.b, s.pose);
        ++(brute_force(s.a.mesh, s.b.mesh, s.pose).empty() ? without : with_pairs);
        if (HasFailure()) return;
    }
    EXPECT_GT(with_pairs, scenes_tried / 3);
    EXPECT_GT(without, scenes_tried / 50);
}

TEST(Collide, FindsWhatBruteForceFindsInMeshesOfFewTriangles) {
    for (const int count_a : {1, 2, 7, 8, 9})
        for (const int count_b : {1, 2, 7, 8, 9})
            for (std::uint64_t seed = 1; seed <= unless_sanitized(3u, 1u); ++seed) {
                const Mesh a = random_soup(seed, count_a, 1.5),
                           b = random_soup(seed + 10, count_b, 1.5);
                SCOPED_TRACE(std::to_string(count_a) + " and " + std::to_string(count_b));
                expect_queries(BuiltMesh(a), BuiltMesh(b), Pose{});
            }
}

TEST(Collide, FindsAPointOnAPoint) {
    const Mesh point{{{1, 2, 3}}, {{0, 0, 0}}};
    const BuiltMesh built(point);
    Pose pose;
    EXPECT_EQ(brute_force(point, point, pose).size(), 1u);
    expect_queries(built, built, pose);
    pose.translation[0] = 1;
    EXPECT_EQ(brute_force(point, point, pose).size(), 0u);
    expect_queries(built, built, pose);
}

TEST(Collide, FindsEveryPairOfTrianglesThatAreAllTheSame) {
    Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    mesh.triangles.assign(33, {0, 1, 2});
    const BuiltMesh built(mesh);
    EXPECT_EQ(brute_force(mesh, mesh, Pose{}).size(), 33u * 33u);
    expect_queries(built, built, Pose{});
}

// Half the way to the origin each time, which attacks the depth of the tree.
Mesh halving_mesh(int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const double s = std::ldexp(1.0, -i);
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {Vec3(s, 0, 0), Vec3(s, s / 4, 0), Vec3(s, 0, s)});
        mesh.triangles.push_back({v, v + 1, v + 2});
    }
    return mesh;
}

TEST(Collide, FindsWhatBruteForceFindsWherePositionsAttackTheDepth) {
    const BuiltMesh a(halving_mesh(unless_sanitized(100, 75)));
    EXPECT_GT(depth(a.topology()), 8);
    expect_queries(a, a, Pose{});
    expect_queries(a, a, {Mat3::Identity(), {0, std::ldexp(1.0, -20), 0}});
}

// A tree that takes one triangle off at each node, much deeper than build_topology's ever are.
Topology chain(std::uint32_t count) {
    Topology topology;
    topology.nodes.push_back({0, count, 0});
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
        const auto left = static_cast<std::uint32_t>(topology.nodes.size());
        topology.nodes.back().left = left;
        topology.nodes.push_back({k, 1, 0});
        topology.nodes.push_back({k + 1, count - k - 1, 0});
    }
    topology.rules.assign(topology.nodes.size(), SplitRule::index);
    for (std::uint32_t i = 0; i < count; ++i) topology.order.push_back(i);
    return topology;
}

TEST(Collide, TakesTreesThatAreAsDeepAsTheirTriangles) {
    constexpr std::uint32_t count = unless_sanitized(400u, 100u);
    const Mesh mesh = random_soup(55, count, 0.05);
    const BuiltMesh a(mesh, chain(count));
    ASSERT_EQ(validate(a.topology(), mesh), "");
    EXPECT_EQ(depth(a.topology()), static_cast<int>(count) - 1);
    const Pose pose{Mat3::Identity(), {0.01, 0.02, 0}};
    const std::vector<IndexPair> expected = brute_force(mesh, mesh, pose);
    EXPECT_FALSE(expected.empty());
    for (const QueryVariant& variant : all_query_variants()) {
        if (variant.options.descent != DescentRule::radius) continue;
        const Collision found = query(a, a, pose, variant);
        EXPECT_EQ(found.pairs, expected) << variant.name();
        EXPECT_GT(found.depth, static_cast<int>(count)) << variant.name();
    }
}

}  // namespace
}  // namespace scb
