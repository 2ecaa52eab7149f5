#include "core/hierarchy/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(LeafOrder, NumbersPointsAsLeavesFirstUseThem) {
    Mesh mesh = height_field(20);
    // Vertices that repeat others, one of them with another sign of 0; and one that is not used.
    mesh.vertices.push_back(mesh.vertices[3]);
    mesh.triangles[5][0] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    mesh.triangles[5][1] = 3;
    mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
    mesh.vertices.push_back({0.0, 5, 5});
    mesh.vertices.push_back({-0.0, 5, 5});
    mesh.triangles.push_back({static_cast<std::uint32_t>(mesh.vertices.size() - 1),
                              static_cast<std::uint32_t>(mesh.vertices.size() - 2), 0});
    const Topology topology = build_topology(mesh);
    const LeafOrder order = leaf_order(mesh, topology);
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < order.corners.size(); ++k) {
        EXPECT_EQ(order.own_first[k], next);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t id = order.corners[k][i];
            EXPECT_LE(id, next);
            next = std::max(next, id + 1);
            EXPECT_EQ(order.points.view()[id], mesh.vertices[mesh.triangles[topology.order[k]][i]]);
        }
    }
    EXPECT_EQ(order.own_first.back(), next);
    EXPECT_EQ(order.points.size(), next);
    for (std::uint32_t a = 0; a < next; ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            ASSERT_NE(order.points.view()[a], order.points.view()[b]);
}

TEST(LeafOrder, IsTheSameForAnyNumberOfThreads) {
    const Mesh mesh = random_soup(42, 20000, 0.05);  // more than a thread takes at a time
    const Topology topology = build_topology(mesh);
    const std::vector<std::uint32_t> welded = joined_vertices(mesh);
    const LeafOrder one = leaf_order(mesh, topology, welded);
    for (const int threads : {2, 5}) {
        const LeafOrder other = leaf_order(mesh, topology, welded, threads);
        EXPECT_EQ(one.corners, other.corners);
        EXPECT_EQ(one.own_first, other.own_first);
        EXPECT_EQ(one.points.x, other.points.x);
        EXPECT_EQ(one.points.y, other.points.y);
        EXPECT_EQ(one.points.z, other.points.z);
    }
}

}  // namespace
}  // namespace scb
