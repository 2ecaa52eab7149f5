#include "core/hierarchy/node_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scb {
namespace {

/// A square of 2 n^2 triangles, and a vertex that none of them uses.
Mesh square_mesh(std::uint32_t n) {
    Mesh mesh;
    mesh.vertices.push_back({9, 9, 9});
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.vertices.emplace_back(x, y, 0);
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t at = 1 + y * (n + 1) + x;
            mesh.triangles.push_back({at, at + 1, at + n + 1});
            mesh.triangles.push_back({at + 1, at + n + 2, at + n + 1});
        }
    return mesh;
}

TEST(NodeMesh, HasTheTrianglesOfTheNodeAndTheVerticesThatTheyUse) {
    const Mesh mesh = square_mesh(8);
    const Topology topology = build_topology(mesh);
    for (std::uint32_t node = 0; node < topology.nodes.size(); ++node) {
        const TopologyNode& n = topology.nodes[node];
        const Mesh part = node_mesh(mesh, topology, node);
        ASSERT_EQ(part.triangles.size(), n.count);
        std::vector<char> used(part.vertices.size());
        for (std::uint32_t i = 0; i < n.count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t vertex = part.triangles[i][k];
                ASSERT_LT(vertex, part.vertices.size());
                used[vertex] = 1;
                EXPECT_EQ(part.vertices[vertex],
                          mesh.vertices[mesh.triangles[topology.order[n.first + i]][k]]);
            }
        EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
    }
}

}  // namespace
}  // namespace scb
