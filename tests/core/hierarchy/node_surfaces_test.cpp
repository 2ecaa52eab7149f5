#include "core/hierarchy/node_surfaces.h"

#include <gtest/gtest.h>

#include "scb/hierarchy.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(NodeSurfaces, ANodeHasWhatItsChildrenHaveTogether) {
    // Three triangles of area 1/2, 2 and 9/2, and one that is a segment.
    Mesh mesh;
    for (const double side : {1.0, 2.0, 3.0, 0.0}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {{10 * side, 0, 0}, {11 * side, 0, 0}, {10 * side, side, 0}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const Topology topology = build_topology(mesh);
    const std::vector<double> surfaces = node_surfaces(tree_shape(topology), mesh);
    ASSERT_EQ(surfaces.size(), 7u);
    EXPECT_DOUBLE_EQ(surfaces[0], 7);
    constexpr double areas[] = {0.5, 2, 4.5, 0};
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        double sum = 0;
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            sum += areas[topology.order[k]];
        EXPECT_NEAR(surfaces[i], sum, 1e-12) << i;
    }
}

}  // namespace
}  // namespace scb
