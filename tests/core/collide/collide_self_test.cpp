#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scb/level_cover.h"
#include "tests/core/collide/collide_checks.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

bool share_vertex(const Mesh& mesh, std::uint32_t i, std::uint32_t j) {
    for (const std::uint32_t a : mesh.triangles[i])
        for (const std::uint32_t b : mesh.triangles[j])
            if (mesh.vertices[a] == mesh.vertices[b]) return true;
    return false;
}

std::vector<IndexPair> brute_force_self(const Mesh& mesh) {
    std::vector<IndexPair> pairs;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::uint32_t j = i + 1; j < mesh.triangles.size(); ++j)
            if (!share_vertex(mesh, i, j) && triangles_overlap(corners(mesh, i), corners(mesh, j)))
                pairs.push_back({i, j});
    return pairs;
}

/// Triangles that cross, that share vertices by index or by position, that lie on each other, and
/// that are degenerate.
Mesh tangled_mesh() {
    Mesh mesh = random_soup(71, 60, 0.5);
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t t = 0; t < 20; ++t) mesh.triangles[t][0] = mesh.triangles[t + 20][1];
    for (std::uint32_t v = 0; v < 15; ++v) mesh.vertices.push_back(mesh.vertices[7 * v]);
    for (std::uint32_t v = 0; v + 2 < 15; v += 3)
        mesh.triangles.push_back({count + v, count + v + 1, count + v + 2});
    mesh.triangles.push_back(mesh.triangles[5]);
    mesh.triangles.push_back({3, 3, 9});
    mesh.vertices.push_back(Vec3(0, -0.0, 0));
    mesh.vertices.push_back(Vec3(0, 0, 0));
    mesh.triangles.push_back({count + 15, 1, 2});
    mesh.triangles.push_back({count + 16, 4, 5});
    return mesh;
}

Collision self_query(const BuiltMesh& side, const QueryVariant& variant, StepRecorder& recorder) {
    return collide_self(side.hierarchies[variant.kind], side.mesh, joined_vertices(side.mesh),
                        variant.options, recorder);
}

/// Every inner node begins one part of the query, and each test belongs to the part of the node
/// above both of its nodes.
void expect_parts(const BuiltMesh& side, const Steps& steps) {
    const std::vector<TopologyNode>& nodes = side.topology().nodes;
    std::set<std::uint32_t> begun;
    for (std::size_t i = 0; i < steps.volumes.size(); ++i) {
        const Step& step = steps.volumes[i];
        const IndexPair at = step.nodes;
        ASSERT_LE(nodes[at.a].first + nodes[at.a].count, nodes[at.b].first) << "A's node is left";
        if (step.parent == no_step) {
            EXPECT_EQ(at.a + 1, at.b);
            EXPECT_TRUE(begun.insert(at.a).second);
            continue;
        }
        ASSERT_LT(step.parent, i);
        const Step& parent = steps.volumes[step.parent];
        EXPECT_EQ(parent.stage, Stage::overlapping);
        EXPECT_NE(parent.nodes.a == at.a, parent.nodes.b == at.b) << "one node was divided";
    }
    EXPECT_EQ(begun.size(), side.mesh.triangles.size() - 1);
}

TEST(CollideSelf, FindsThePairsThatShareNoVertexByEveryTest) {
    const BuiltMesh side(tangled_mesh());
    const std::vector<IndexPair> expected = brute_force_self(side.mesh);
    ASSERT_GT(expected.size(), 20u);
    for (const QueryVariant& variant : all_query_variants()) {
        SCOPED_TRACE(variant.name());
        StepRecorder recorder;
        const Collision found = self_query(side, variant, recorder);
        EXPECT_EQ(found.pairs, expected);
        EXPECT_TRUE(found.complete);
        expect_same(collide_self(side.hierarchies[variant.kind], side.mesh,
                                 joined_vertices(side.mesh), variant.options),
                    found);
        expect_parts(side, recorder.steps);
        std::set<IndexPair> tested;
        std::uint64_t tests = 0, neighbors = 0;
        for (const ItemStep& items : recorder.steps.items) {
            const auto [a, b] = items.items;
            EXPECT_TRUE(tested.insert({std::min(a, b), std::max(a, b)}).second);
            EXPECT_EQ(items.neighbors, share_vertex(side.mesh, a, b));
            EXPECT_FALSE(items.neighbors && items.hit);
            ++(items.neighbors ? neighbors : tests);
        }
        EXPECT_EQ(found.n_p, tests);
        EXPECT_GT(neighbors, 0u);
        EXPECT_EQ(found.n_v, recorder.steps.volumes.size());
        int deepest = 0;
        for (const Step& step : recorder.steps.volumes)
            deepest = std::max(deepest, step.depth_a + step.depth_b);
        EXPECT_EQ(found.depth, deepest);
    }
}

TEST(CollideSelf, EndsAtSoManyPairs) {
    const BuiltMesh side(tangled_mesh());
    const std::vector<IndexPair> all = brute_force_self(side.mesh);
    for (QueryVariant variant : all_query_variants()) {
        SCOPED_TRACE(variant.name());
        for (const std::size_t most : {std::size_t{1}, std::size_t{5}, all.size() + 1}) {
            variant.options.max_pairs = most;
            StepRecorder recorder;
            const Collision found = self_query(side, variant, recorder);
            EXPECT_EQ(found.pairs.size(), std::min(most, all.size()));
            EXPECT_EQ(found.complete, most > all.size());
            EXPECT_TRUE(
                std::includes(all.begin(), all.end(), found.pairs.begin(), found.pairs.end()));
            if (!found.complete) {
                EXPECT_TRUE(recorder.steps.items.back().hit);
                EXPECT_EQ(recorder.steps.items.back().step + 1, recorder.steps.volumes.size());
            }
        }
    }
}

// As of two bodies, a volume may stick out of its parent's: some pairs that overlap are not found.
TEST(CollideSelf, AtALevelFindsPairsOfTheCoverAndAllThatHoldIntersections) {
    const BuiltMesh side(tangled_mesh());
    const auto joined = joined_vertices(side.mesh);
    const std::vector<TopologyNode>& nodes = side.topology().nodes;
    const std::vector<IndexPair> all = brute_force_self(side.mesh);
    for (const int level : {0, 1, 3, 100}) {
        SCOPED_TRACE(level);
        const std::vector<std::uint32_t> cover = level_cover(side.topology(), level);
        std::map<std::uint32_t, std::uint32_t> node_of;  // of a triangle
        for (const std::uint32_t node : cover)
            for (std::uint32_t k = 0; k < nodes[node].count; ++k)
                node_of[side.topology().order[nodes[node].first + k]] = node;
        for (const AnyHierarchy& hierarchy : side.hierarchies) {
            CollideOptions options;
            options.stop_level = level;
            const Collision found = collide_self(hierarchy, side.mesh, joined, options);
            EXPECT_EQ(found.n_p, 0u);
            std::set<IndexPair> pairs;
            for (const IndexPair pair : found.pairs) {
                EXPECT_TRUE(pairs.insert(pair).second);
                EXPECT_LT(nodes[pair.a].first, nodes[pair.b].first);
                for (const std::uint32_t node : {pair.a, pair.b})
                    EXPECT_TRUE(std::find(cover.begin(), cover.end(), node) != cover.end());
            }
            for (const IndexPair pair : all) {
                std::uint32_t a = node_of.at(pair.a), b = node_of.at(pair.b);
                if (nodes[a].first > nodes[b].first) std::swap(a, b);
                EXPECT_TRUE(a == b || pairs.contains({a, b}));
            }
        }
    }
}

TEST(CollideSelf, OfOneTriangleMakesNoTest) {
    const BuiltMesh side(random_soup(72, 1, 0.5));
    const Collision found =
        collide_self(side.hierarchies[0], side.mesh, joined_vertices(side.mesh));
    EXPECT_TRUE(found.pairs.empty());
    EXPECT_EQ(found.n_v, 0u);
    EXPECT_TRUE(found.complete);
}

TEST(JoinedVertices, AreTheFirstAtTheirPosition) {
    Mesh mesh;
    mesh.vertices = {Vec3(1, 2, 3),   Vec3(0, 0, 0),    Vec3(1, 2, 3),
                     Vec3(NAN, 0, 0), Vec3(0, -0.0, 0), Vec3(1, 2, 4)};
    EXPECT_EQ(joined_vertices(mesh), (std::vector<std::uint32_t>{0, 1, 0, UINT32_MAX, 1, 5}));
}

}  // namespace
}  // namespace scb
