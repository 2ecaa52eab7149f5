#include "core/analysis/tested_triangles.h"

#include <gtest/gtest.h>

#include <map>

#include "core/analysis/triangle_heat.h"
#include "tests/core/analysis/made_query.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(TestedTriangles, CountsTheTestsOfEachTriangleOfASide) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    const QueryTrace frame =
        record_frame(mesh, mesh, 0, pose, asking(VolumeKind::scb, OverlapTest::symmetric));
    const TreeShape shape = tree_shape(mesh.topology());
    for (const std::size_t side : {0u, 1u}) {
        std::map<std::uint32_t, std::uint64_t> expected;
        for (const ItemStep& test : frame.steps.items)
            ++expected[side == 0 ? test.items.a : test.items.b];
        const auto nodes = triangle_heat(frame.steps, shape, side, HeatOf::volumes);
        const std::vector<TestedTriangle> tested = tested_triangles(frame.steps, shape, side);
        ASSERT_EQ(tested.size(), expected.size());
        auto next = expected.begin();
        for (const TestedTriangle& one : tested) {
            EXPECT_EQ(one.triangle, next->first);
            EXPECT_EQ(one.items, next->second);
            EXPECT_EQ(one.volumes, nodes[one.triangle]);
            ++next;
        }
        EXPECT_EQ(item_tests(tested), frame.found.n_p);
    }
}

TEST(TestedTriangles, OfSeveralQueriesAreAdded) {
    std::vector<TestedTriangle> sum = {{2, 1, 10}, {5, 2, 20}};
    add_tests(sum, {{1, 7, 70}, {5, 3, 30}, {9, 1, 1}});
    ASSERT_EQ(sum.size(), 4u);
    EXPECT_EQ(sum[0].triangle, 1u);
    EXPECT_EQ(sum[2].triangle, 5u);
    EXPECT_EQ(sum[2].items, 5u);
    EXPECT_EQ(sum[2].volumes, 50u);
    EXPECT_EQ(item_tests(sum), 14u);
}

TEST(TestedTriangles, TheCostliestAreFirstAndOfEqualOnesTheLowestNumber) {
    Mesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(0, 2, 0)};
    mesh.triangles.assign(10, {0, 1, 2});
    const auto costly =
        costly_triangles({{1, 3, 5}, {4, 9, 1}, {6, 3, 6}, {7, 3, 5}, {8, 1, 99}}, mesh, 4);
    std::vector<std::uint32_t> numbers;
    for (const CostlyTriangle& one : costly) numbers.push_back(one.tests.triangle);
    EXPECT_EQ(numbers, (std::vector<std::uint32_t>{4, 6, 1, 7}));
    EXPECT_DOUBLE_EQ(costly[0].size.longest_side, std::sqrt(68.0));
    EXPECT_DOUBLE_EQ(costly[0].size.slenderness, 68.0 / 16);
}

}  // namespace
}  // namespace scb
