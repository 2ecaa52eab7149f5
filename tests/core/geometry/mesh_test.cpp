#include "scb/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scb/error.h"

namespace scb {
namespace {

std::string refusal(const Mesh& mesh) {
    try {
        check_mesh(mesh, "part.ply");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

Mesh one_triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}; }

TEST(CheckMesh, AcceptsATriangleAndADegenerateOne) {
    EXPECT_EQ(refusal(one_triangle()), "");
    Mesh mesh = one_triangle();
    mesh.triangles.push_back({1, 1, 1});
    EXPECT_EQ(refusal(mesh), "");
}

TEST(CheckMesh, NamesTheFirstOffender) {
    EXPECT_NE(refusal({}).find("part.ply: the mesh has no triangles"), std::string::npos);
    Mesh mesh = one_triangle();
    mesh.triangles.push_back({0, 1, 3});
    EXPECT_NE(refusal(mesh).find("triangle 1 names vertex 3, but the mesh has 3"),
              std::string::npos);
    mesh = one_triangle();
    mesh.vertices[2][1] = std::nan("");
    EXPECT_NE(refusal(mesh).find("vertex 2 of triangle 0 has the coordinate y = nan"),
              std::string::npos);
    mesh.vertices[2][1] = 1e200;
    EXPECT_NE(refusal(mesh).find("y = 1e+200"), std::string::npos);
}

TEST(CheckMesh, RefusesWhatIsTooSmallToSquareButNotAPoint) {
    Mesh mesh = one_triangle();
    for (Vec3& v : mesh.vertices) v *= 1e-70;
    EXPECT_NE(refusal(mesh).find("the mesh is only 1e-70 long"), std::string::npos);
    for (Vec3& v : mesh.vertices) v *= 0;
    EXPECT_EQ(refusal(mesh), "");
}

TEST(CheckMesh, IgnoresUnusedVertices) {
    Mesh mesh = one_triangle();
    mesh.vertices.emplace_back(std::nan(""), 0, 0);
    mesh.vertices.emplace_back(50, 0, 0);
    EXPECT_EQ(refusal(mesh), "");
    EXPECT_EQ(bounding_box(mesh).upper, Vec3(1, 1, 0));
}

}  // namespace
}  // namespace scb
