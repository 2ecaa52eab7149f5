#include "core/judge/self_pairs.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

/// Triangle 0 lies; the others share some of its vertices, or none.
Mesh folded(const std::vector<Vec3>& more, const std::vector<Triangle>& triangles) {
    Mesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
    mesh.vertices.insert(mesh.vertices.end(), more.begin(), more.end());
    mesh.triangles = {{0, 1, 2}};
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    return mesh;
}

TEST(SelfPairs, TrianglesWithAVertexInCommonAreNoPair) {
    // The second shares an edge by index, the third a vertex by position, the fourth none.
    const Mesh mesh = folded({Vec3(2, 2, 0), Vec3(-0.0, 0, 0), Vec3(-1, 0, 1), Vec3(-1, -1, 1),
                              Vec3(0.5, 0.5, -1), Vec3(0.6, 0.5, 1), Vec3(0.5, 0.6, 1)},
                             {{1, 3, 2}, {4, 5, 6}, {7, 8, 9}});
    const SelfPairs pairs(mesh);
    EXPECT_TRUE(pairs.share_vertex(0, 1));
    EXPECT_TRUE(pairs.share_vertex(0, 2)) << "-0 equals 0";
    EXPECT_FALSE(pairs.share_vertex(0, 3));
    EXPECT_EQ(pairs.all(build_hierarchy<Obb>(mesh)), (std::vector<IndexPair>{{0, 3}}));
}

TEST(SelfPairs, NeighboursMayMeetElsewhere) {
    // One vertex in common; the other edge ends beside the triangle, or goes through it.
    EXPECT_FALSE(SelfPairs(folded({Vec3(-1, 0, 1), Vec3(-1, -1, 1)}, {{0, 3, 4}}))
                     .may_meet_elsewhere(0, 1, 1e-9));
    EXPECT_TRUE(SelfPairs(folded({Vec3(0.5, 0.5, 1), Vec3(0.5, 0.5, -1)}, {{0, 3, 4}}))
                    .may_meet_elsewhere(0, 1, 1e-9));
    // An edge in common: flat on the other side, upright, folded back, nearly folded back.
    const auto with_edge = [](const Vec3& apex) {
        return SelfPairs(folded({apex}, {{1, 0, 3}})).may_meet_elsewhere(0, 1, 1e-9);
    };
    EXPECT_FALSE(with_edge(Vec3(1, -1, 0)));
    EXPECT_FALSE(with_edge(Vec3(1, 0, 1)));
    EXPECT_FALSE(with_edge(Vec3(1, 1, 0.1)));
    EXPECT_TRUE(with_edge(Vec3(1, 1, 0)));
    EXPECT_TRUE(with_edge(Vec3(-1, 3, 0))) << "neither apex is in the other triangle";
    EXPECT_TRUE(with_edge(Vec3(1, 1, 1e-12)));
    // All vertices: the same triangle twice.
    EXPECT_TRUE(SelfPairs(folded({}, {{1, 2, 0}})).may_meet_elsewhere(0, 1, 1e-9));
}

}  // namespace
}  // namespace scb
