#include "core/geometry/mesh_parts.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

using Triangles = std::vector<Triangle>;

TEST(MeshParts, JoinCornersAtOnePlace) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, -0.0, 0}, {0, 1, -0.0}};
    mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
    EXPECT_EQ(joined_triangles(mesh), (Triangles{{0, 1, 2}, {3, 2, 1}}));
}

TEST(MeshParts, AreNumberedByTheirFirstTriangles) {
    const MeshParts parts = mesh_parts({{7, 8, 9}, {0, 1, 2}, {9, 3, 4}, {2, 5, 6}, {7, 8, 9}}, 10);
    EXPECT_EQ(parts.count, 2u);
    EXPECT_EQ(parts.of_triangle, (std::vector<std::uint32_t>{0, 1, 0, 1, 0}));
    EXPECT_EQ(mesh_parts({}, 0).count, 0u);
}

TEST(MeshParts, AreClosedWhereEveryEdgeHasAnEvenNumberOfTriangles) {
    const Triangles tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    EXPECT_TRUE(are_closed(tetrahedron));
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        Triangles open = tetrahedron;
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(left_out));
        EXPECT_FALSE(are_closed(open));
    }
    Triangles more = tetrahedron;
    more.push_back({5, 5, 6});  // has no area
    EXPECT_TRUE(are_closed(more));
    more.push_back({0, 1, 4});
    EXPECT_FALSE(are_closed(more));
    more.push_back({1, 4, 0});
    EXPECT_TRUE(are_closed(more));
}

}  // namespace
}  // namespace scb
