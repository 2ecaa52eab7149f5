#include "core/analysis/triangle_heat.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(TriangleHeat, CountsTheTestsOfNodesThatHoldATriangleAndItsOwn) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    for (const VolumeKind kind : {VolumeKind::scb, VolumeKind::obb}) {
        const TraceFrame frame =
            record_frame(mesh, mesh, 0, pose, asking(kind, OverlapTest::symmetric));
        const Topology& topology = mesh.topology();
        for (const std::size_t side : {0u, 1u}) {
            const auto on_side = [&](const IndexPair& p) { return side == 0 ? p.a : p.b; };
            std::vector<std::uint32_t> volumes(topology.order.size()), triangles(volumes);
            for (const VolumeTest& test : frame.events.volume_tests) {
                const TopologyNode& node = topology.nodes[on_side(test.nodes)];
                for (std::uint32_t i = 0; i < node.count; ++i)
                    ++volumes[topology.order[node.first + i]];
            }
            for (const TriangleTest& test : frame.events.triangle_tests)
                ++triangles[on_side(test.triangles)];
            EXPECT_EQ(triangle_heat(frame.events, topology, side, HeatOf::volumes), volumes);
            const auto heat = triangle_heat(frame.events, topology, side, HeatOf::triangles);
            EXPECT_EQ(heat, triangles);
            EXPECT_EQ(std::accumulate(heat.begin(), heat.end(), std::uint64_t{0}), frame.found.n_p);
        }
    }
}

}  // namespace
}  // namespace scb
