#include "core/analysis/triangle_heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/analysis/attribution.h"
#include "tests/core/analysis/made_query.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(TriangleHeat, CountsTheTestsOfNodesThatHoldATriangleAndItsOwn) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    for (const VolumeKind kind : {VolumeKind::scb, VolumeKind::obb}) {
        const QueryTrace frame =
            record_frame(mesh, mesh, 0, pose, asking(kind, OverlapTest::symmetric));
        const Topology& topology = mesh.topology();
        const TreeShape shape = tree_shape(topology);
        for (const std::size_t side : {0u, 1u}) {
            const auto on_side = [&](const IndexPair& p) { return side == 0 ? p.a : p.b; };
            std::vector<std::uint32_t> volumes(topology.order.size()), triangles(volumes);
            for (const Step& test : frame.steps.volumes) {
                const TopologyNode& node = topology.nodes[on_side(test.nodes)];
                for (std::uint32_t i = 0; i < node.count; ++i)
                    ++volumes[topology.order[node.first + i]];
            }
            for (const ItemStep& test : frame.steps.items) ++triangles[on_side(test.items)];
            EXPECT_EQ(triangle_heat(frame.steps, shape, side, HeatOf::volumes), volumes);
            const auto heat = triangle_heat(frame.steps, shape, side, HeatOf::triangles);
            EXPECT_EQ(heat, triangles);
            EXPECT_EQ(std::accumulate(heat.begin(), heat.end(), std::uint64_t{0}), frame.found.n_p);
        }
    }
}

TEST(TriangleHeat, WastedTestsAreThoseOfTheAttribution) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    for (const int stop_level : {-1, 3}) {
        TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
        header.options.stop_level = stop_level;
        const QueryTrace frame = record_frame(mesh, mesh, 0, pose, header);
        ASSERT_FALSE(frame.found.pairs.empty());
        const std::vector<bool> wasted = wasted_tests(frame.steps, outcomes_of(header, frame));
        ASSERT_EQ(wasted.size(), frame.found.n_v);
        const auto count =
            static_cast<std::uint64_t>(std::count(wasted.begin(), wasted.end(), true));
        EXPECT_FALSE(wasted[0]);
        EXPECT_GT(count, 0u);
        const TreeShape shape = tree_shape(mesh.topology());
        const auto heat = triangle_heat(frame.steps, shape, 0, HeatOf::wasted, wasted),
                   all = triangle_heat(frame.steps, shape, 0, HeatOf::volumes);
        for (std::size_t t = 0; t < heat.size(); ++t) EXPECT_LT(heat[t], all[t]);
        if (stop_level >= 0) continue;
        const AnyHierarchy& hierarchy = mesh.hierarchies[static_cast<std::size_t>(VolumeKind::scb)];
        const Attribution attribution =
            attribute(hierarchy, hierarchy, header, frame, frame.found.pairs);
        EXPECT_EQ(count, attribution.counts.wasted().volume_tests);
        EXPECT_EQ(wasted_tests(attribution), wasted);
    }
}

TEST(TriangleHeat, ATestIsWastedWhereNothingBelowItsParentMeets) {
    Outcomes outcomes;
    // 0 led to 1 and 4, 1 to 2 and 3, 4 to 5.
    const Steps steps = steps_with_parents({no_step, 0, 1, 1, 0, 4});
    for (const Stage met : {Stage::triangles_meet, Stage::found}) {
        outcomes = {Stage::divided_a, Stage::divided_b,      Stage::ball_ball, met,
                    Stage::divided_b, Stage::triangles_apart};
        EXPECT_EQ(wasted_tests(steps, outcomes),
                  (std::vector{false, false, false, false, false, true}));
    }
    // A self query must reach neighbors, even if the last triangles of the leaf are apart.
    Steps neighbors = steps;
    neighbors.items.push_back({.items = {0, 1}, .step = 3, .neighbors = true});
    outcomes[3] = Stage::triangles_apart;
    EXPECT_EQ(wasted_tests(neighbors, outcomes),
              (std::vector{false, false, false, false, false, true}));
    outcomes[3] = Stage::left_over;
    EXPECT_EQ(wasted_tests(steps, outcomes), (std::vector{false, true, true, true, true, true}));
}

}  // namespace
}  // namespace scb
