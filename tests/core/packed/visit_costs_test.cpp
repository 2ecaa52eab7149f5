#include "core/packed/visit_costs.h"

#include <gtest/gtest.h>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(VisitCosts, AreTheSquaredSumOfSidesAndTheArea) {
    const Mesh mesh{{{0, 0, 0}, {1, 2, 3}, {0.5, 0.5, 0.5}}, {{0, 1, 2}}};
    const auto costs = visit_costs(mesh, build_topology(mesh));
    ASSERT_EQ(costs.size(), 1u);
    EXPECT_EQ(costs[0], 36 + 2 * (2 + 6 + 3));
}

TEST(VisitCosts, AreOfTheBoxesOfAllTrianglesOfANode) {
    const Mesh mesh = height_field(100);  // more than a thread takes at a time
    const Topology topology = build_topology(mesh);
    const auto costs = visit_costs(mesh, topology);
    for (std::size_t i = 0; i < costs.size(); i += 37) {
        const TopologyNode& node = topology.nodes[i];
        Box box;
        for (std::uint32_t k = 0; k < node.count; ++k)
            for (const std::uint32_t v : mesh.triangles[topology.order[node.first + k]])
                box.add(mesh.vertices[v]);
        const Vec3 side = box.upper - box.lower;
        const double sum = side.sum();
        EXPECT_FLOAT_EQ(costs[i], static_cast<float>(2 * sum * sum - side.squaredNorm())) << i;
    }
    EXPECT_EQ(visit_costs(mesh, topology, 3), costs);
}

}  // namespace
}  // namespace scb
