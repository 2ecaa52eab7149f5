#include "core/analysis/wasted_cost.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/analysis/triangle_heat.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(WastedCost, OfAllTrianglesOfBothBodiesIsThatOfTheWastedTests) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    const QueryTrace frame = record_frame(mesh, mesh, 0, pose, header);
    const std::vector<bool> wasted = wasted_tests(frame.steps, outcomes_of(header, frame));
    const TreeShape shape = tree_shape(mesh.topology());
    const TestCosts costs{3, 5};
    const auto of_volumes =
                   3.0 * static_cast<double>(std::count(wasted.begin(), wasted.end(), true)),
               of_triangles = 5.0 * static_cast<double>(frame.found.n_p - frame.found.pairs.size()),
               all = 3.0 * static_cast<double>(frame.found.n_v) +
                     5.0 * static_cast<double>(frame.found.n_p);
    ASSERT_GT(of_volumes, 0);
    ASSERT_GT(of_triangles, 0);
    double sum = 0;
    for (const std::size_t side : {0u, 1u}) {
        double of_side = 0;
        for (const double cost : wasted_cost(frame.steps, shape, side, wasted, costs)) {
            EXPECT_GE(cost, 0);
            of_side += cost;
        }
        EXPECT_NEAR(of_side, (of_volumes + of_triangles) / all / 2, 1e-12);
        sum += of_side;
    }
    EXPECT_NEAR(sum, (of_volumes + of_triangles) / all, 1e-12);
}

TEST(WastedCost, OfANodeIsSharedByTheTrianglesBelowIt) {
    // A root with two leaves of one triangle each.
    TreeShape shape;
    shape.parents = {no_index, 0, 0};
    shape.depths = {0, 1, 1};
    shape.first_child = {1, no_index, no_index};
    shape.next_sibling = {no_index, 2, no_index};
    shape.order = {0, 1, 2};
    shape.roots = {0};
    shape.holder = {1, 2};
    Steps steps;
    steps.volumes = {{{0, 0}, 0, 0, Stage::overlapping, no_step},
                     {{1, 0}, 1, 0, Stage::overlapping, 0},
                     {{2, 0}, 1, 0, Stage::ball_ball, 0}};
    steps.items = {{{0, 0}, 1, false}, {{0, 1}, 1, true}, {{0, 1}, 1, false, true}};
    // Three tests of volumes cost 6 and two of triangles 4; all of volumes are wasted here.
    const std::vector<double> cost = wasted_cost(steps, shape, 0, {true, true, true}, {2, 2});
    ASSERT_EQ(cost.size(), 2u);
    // Half of the root's test, halved; half of the own node's test; half of the vain triangle test.
    EXPECT_DOUBLE_EQ(cost[0], (0.5 + 1 + 1) / 10);
    EXPECT_DOUBLE_EQ(cost[1], (0.5 + 1) / 10);
    EXPECT_EQ(wasted_cost({}, shape, 0, {}, {}), std::vector<double>(2));
}

}  // namespace
}  // namespace scb
