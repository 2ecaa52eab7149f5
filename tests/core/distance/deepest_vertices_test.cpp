#include "core/distance/deepest_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/hierarchy/mesh_parity.h"
#include "scb/any_collide.h"
#include "scb/triangle_distance.h"
#include "tests/core/box_mesh.h"
#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

using Deepest = std::vector<std::optional<DeepVertex>>;

/// A closed mesh about a point, not convex: an octahedron whose triangles are divided.
Mesh bumpy_ball(Random& random, int divisions, double bumps) {
    Mesh mesh{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int i = 0; i < divisions; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t u, std::uint32_t v) {
            const auto [at, is_new] = middles.try_emplace(
                std::minmax(u, v), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back((mesh.vertices[u] + mesh.vertices[v]).normalized());
            return at->second;
        };
        std::vector<Triangle> divided;
        for (const auto [u, v, w] : mesh.triangles) {
            const std::uint32_t uv = middle(u, v), vw = middle(v, w), wu = middle(w, u);
            for (const Triangle& t : {Triangle{u, uv, wu}, Triangle{uv, v, vw}, Triangle{wu, vw, w},
                                      Triangle{uv, vw, wu}})
                divided.push_back(t);
        }
        mesh.triangles = std::move(divided);
    }
    for (Vec3& v : mesh.vertices) v *= 1 + random.uniform(-bumps, bumps);
    return mesh;
}

void add(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Two bodies with their pairs and patches.
struct Bodies {
    BuiltMesh a, b;
    Pose pose;
    JoinedMesh joined_a, joined_b;
    std::vector<IndexPair> pairs;
    std::vector<ContactPatch> patches;

    Bodies(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& b_to_a)
        : a(mesh_a), b(mesh_b), pose(b_to_a), joined_a(a.mesh), joined_b(b.mesh) {
        pairs = collide(a.hierarchies[0], a.mesh, b.hierarchies[0], b.mesh, pose).pairs;
        patches = contact_patches({a.mesh, joined_a.triangles}, {b.mesh, joined_b.triangles}, pose,
                                  pairs);
    }
    PatchBody body(std::size_t side, std::size_t kind = 0) const {
        return side == 0 ? PatchBody{a.mesh, joined_a, a.hierarchies[kind], {}}
                         : PatchBody{b.mesh, joined_b, b.hierarchies[kind], pose};
    }
    /// The deepest vertices of one side inside the other.
    Deepest deepest(std::size_t side, std::size_t kind = 0) const {
        return deepest_vertices(body(side, kind), body(1 - side, kind), side, pairs, patches);
    }
};

/// The definition, without a tree and by tests of all vertices.
struct Oracle {
    std::vector<bool> is_inside;
    std::vector<double> depth;
    Deepest deepest;
    std::size_t in_no_patch = 0;

    Oracle(const Bodies& bodies, std::size_t side) {
        const PatchBody inner = bodies.body(side), outer = bodies.body(1 - side);
        Mesh placed = outer.mesh;
        for (Vec3& v : placed.vertices) v = transform_point(outer.to_a, v);
        const Topology topology = build_topology(placed);
        const MeshParity parity(placed, topology);
        std::vector<Vec3> at;
        for (std::uint32_t v = 0; v < inner.mesh.vertices.size(); ++v) {
            at.push_back(transform_point(inner.to_a, inner.mesh.vertices[v]));
            is_inside.push_back(parity.side(at[v]) == PointSide::in);
            double least = HUGE_VAL;
            if (is_inside[v])
                for (std::uint32_t t = 0; t < placed.triangles.size(); ++t)
                    least = std::min(
                        least,
                        triangle_distance({at[v], at[v], at[v]}, corners(placed, t)).distance);
            depth.push_back(least);
        }
        std::vector<bool> in_a_patch(is_inside.size());
        for (const ContactPatch& patch : bodies.patches) {
            const std::vector<bool> reached =
                reached_from(inner, triangles_of(patch, bodies.pairs, side));
            std::optional<DeepVertex>& best = deepest.emplace_back();
            for (std::uint32_t v = 0; v < reached.size(); ++v) {
                if (!reached[v]) continue;
                in_a_patch[v] = true;
                if (!best || depth[v] > best->depth) best = DeepVertex{v, at[v], depth[v], 0};
            }
        }
        for (std::size_t v = 0; v < is_inside.size(); ++v)
            in_no_patch += is_inside[v] && !in_a_patch[v];
    }

    /// The vertices inside that edges between vertices inside connect with these triangles.
    std::vector<bool> reached_from(const PatchBody& inner,
                                   const std::vector<std::uint32_t>& triangles) const {
        std::vector<bool> reached(is_inside.size());
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t v : inner.joined.triangles[t]) reached[v] = is_inside[v];
        for (bool grows = true; grows;) {
            grows = false;
            for (const Triangle& t : inner.joined.triangles)
                for (const std::uint32_t u : t)
                    for (const std::uint32_t v : t)
                        if (reached[u] && is_inside[v] && !reached[v]) grows = reached[v] = true;
        }
        return reached;
    }
};

void expect_same(const Deepest& found, const Deepest& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].has_value(), expected[i].has_value()) << i;
        if (!found[i]) continue;
        EXPECT_EQ(found[i]->vertex, expected[i]->vertex);
        EXPECT_EQ(found[i]->depth, expected[i]->depth);
        EXPECT_EQ(found[i]->at, expected[i]->at);
    }
}

TEST(DeepestVertices, AreTheDeepestOfAllVertices) {
    std::size_t none = 0, some = 0, several = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Random random(seed);
        Pose pose = random_pose(random);
        pose.translation = pose.translation.normalized() * random.uniform(0.2, 1.9);
        const Mesh a = bumpy_ball(random, 2, 0.6),
                   b = bumpy_ball(random, 1 + static_cast<int>(random.below(2)), 0.6);
        const Bodies bodies(a, b, pose);
        several += bodies.patches.size() > 1;
        for (const std::size_t side : {0u, 1u}) {
            const Oracle oracle(bodies, side);
            EXPECT_EQ(oracle.in_no_patch, 0u) << "balls are of one part";
            const Deepest found = bodies.deepest(side);
            expect_same(found, oracle.deepest);
            for (const auto& deepest : found) ++(deepest ? some : none);
        }
    }
    EXPECT_GT(several, 0u);
    EXPECT_GT(some, 0u);
    EXPECT_GT(none, 0u);
}

TEST(DeepestVertices, AreTheSameForAllVolumes) {
    Random random(3);
    Pose pose;
    pose.translation = {0.6, 0.5, 0.3};
    const Mesh a = bumpy_ball(random, 2, 0.2), b = bumpy_ball(random, 3, 0.2);
    const Bodies bodies(a, b, pose);
    for (const std::size_t side : {0u, 1u})
        for (std::size_t kind = 1; kind < all_volume_kinds().size(); ++kind)
            expect_same(bodies.deepest(side, kind), bodies.deepest(side));
}

// Most vertices inside are far from the contact, and are not tested themselves.
TEST(DeepestVertices, AreFoundByAWalk) {
    Random random(4);
    const Bodies bodies(bumpy_ball(random, 4, 0), box_mesh({-5, -5, -5}, {5, 5, 0.5}), {});
    ASSERT_EQ(bodies.patches.size(), 1u);
    const Deepest found = bodies.deepest(0);
    ASSERT_TRUE(found[0]);
    EXPECT_EQ(found[0]->at, Vec3(0, 0, -1));
    EXPECT_EQ(found[0]->depth, 1.5);
    // The triangle of the box that is nearest: of its upper face.
    EXPECT_EQ(bodies.b.mesh.vertices[bodies.b.mesh.triangles[found[0]->nearest][0]][2], 0.5);
    EXPECT_FALSE(bodies.deepest(1)[0]) << "no corner of the box is in the ball";
}

TEST(DeepestVertices, BelongToEachPatchThatAWalkConnects) {
    // A rod with a ring of vertices between its ends.
    Mesh rod = box_mesh({-0.5, -0.5, -5}, {0.5, 0.5, 0.25});
    for (int i = 0; i < 4; ++i)
        rod.vertices.emplace_back(rod.vertices[static_cast<std::size_t>(i)][0],
                                  rod.vertices[static_cast<std::size_t>(i)][1], 5);
    rod.triangles.erase(rod.triangles.begin() + 2, rod.triangles.begin() + 4);
    for (const Triangle& t :
         {Triangle{8, 9, 10}, Triangle{9, 11, 10}, Triangle{4, 5, 8}, Triangle{5, 9, 8},
          Triangle{6, 10, 7}, Triangle{7, 10, 11}, Triangle{4, 8, 6}, Triangle{6, 8, 10},
          Triangle{5, 7, 9}, Triangle{7, 11, 9}})
        rod.triangles.push_back(t);
    const Bodies bodies(rod, box_mesh({-3, -3, -1}, {3, 3, 1}), {});
    ASSERT_TRUE(bodies.joined_a.is_closed);
    ASSERT_EQ(bodies.patches.size(), 2u);
    const Deepest found = bodies.deepest(0);
    ASSERT_TRUE(found[0] && found[1]);
    EXPECT_EQ(found[0]->vertex, 4u);
    EXPECT_EQ(found[1]->vertex, 4u);
    EXPECT_EQ(found[0]->depth, 0.75);
}

TEST(DeepestVertices, LeaveOutPartsThatMeetNothing) {
    Mesh two = box_mesh({-1, -1, -1}, {1, 1, 1});
    add(two, box_mesh({4, 4, 4}, {5, 5, 5}));
    const Bodies bodies(two, box_mesh({0, 0, 0}, {10, 10, 10}), {});
    const Deepest found = bodies.deepest(0);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_TRUE(found[0]);
    EXPECT_EQ(found[0]->vertex, 7u);
    EXPECT_EQ(found[0]->depth, 1);
    EXPECT_EQ(Oracle(bodies, 0).in_no_patch, 8u);
}

TEST(DeepestVertices, OfBodiesFaceOnFaceAreNone) {
    const Bodies bodies(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({0.25, 0.25, 1}, {0.5, 0.5, 2}),
                        {});
    ASSERT_EQ(bodies.patches.size(), 1u);
    for (const std::size_t side : {0u, 1u}) EXPECT_FALSE(bodies.deepest(side)[0]);
}

TEST(DeepestVertices, OfASoupHaveTheFirstVertexAtTheirPlace) {
    Random random(6);
    const Mesh ball = bumpy_ball(random, 2, 0.2);
    Mesh soup;
    for (const Triangle& t : ball.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) soup.vertices.push_back(ball.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const Mesh wall = box_mesh({-5, -5, -5}, {5, 5, 0});
    const Bodies of_ball(ball, wall, {}), of_soup(soup, wall, {});
    ASSERT_TRUE(of_soup.joined_a.is_closed);
    const auto expected = of_ball.deepest(0), found = of_soup.deepest(0);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i]->at, expected[i]->at);
        EXPECT_EQ(found[i]->depth, expected[i]->depth);
        for (std::uint32_t v = 0; v < found[i]->vertex; ++v)
            EXPECT_NE(soup.vertices[v], found[i]->at);
    }
}

}  // namespace
}  // namespace scb
