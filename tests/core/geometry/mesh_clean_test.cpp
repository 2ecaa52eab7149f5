#include "core/geometry/mesh_clean.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

TEST(MeshClean, LeavesOutCopiesAndTrianglesWithoutArea) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {2, 0, 4}, {0, 1, 5}, {1, 1, 2}, {2, 4, 0}};
    const CleanMesh clean = clean_mesh(mesh);
    EXPECT_EQ(clean.origin, (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(clean.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 5}}));
    EXPECT_EQ(clean.mesh.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(clean.copies, 2u);
    EXPECT_EQ(clean.degenerate, 2u);
    EXPECT_EQ(clean_mesh(clean.mesh).origin.size(), 2u);
}

TEST(MeshClean, KeepsOneTriangleAtLeast) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}};
    const CleanMesh clean = clean_mesh(mesh);
    EXPECT_EQ(clean.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(clean.copies, 1u);
    EXPECT_EQ(clean.degenerate, 1u);
}

}  // namespace
}  // namespace scb
