#include "core/geometry/mesh_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/geometry/mesh_facts.h"

namespace scb {
namespace {

constexpr std::size_t many = 1'000'000;

/// A closed box, 40 x 1 x 1, of twelve triangles.
Mesh long_box() {
    Mesh mesh;
    for (const double x : {0.0, 40.0})
        for (const double y : {0.0, 1.0})
            for (const double z : {0.0, 1.0}) mesh.vertices.emplace_back(x, y, z);
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5},
                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return mesh;
}

Vec3 area_vector(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners t = corners(mesh, triangle);
    return cross(t[1] - t[0], t[2] - t[0]) / 2;
}

TEST(MeshCut, PiecesAreShortAndMakeUpTheirTriangle) {
    const Mesh box = long_box();
    const auto cut = cut_triangles(box, {}, 3, many);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cut, 8u);
    ASSERT_EQ(cut->origin.size(), cut->mesh.triangles.size());
    EXPECT_EQ(cut->pieces + 4, cut->mesh.triangles.size());
    std::vector<Vec3> sums(box.triangles.size(), Vec3::Zero());
    for (std::uint32_t i = 0; i < cut->origin.size(); ++i) {
        EXPECT_LE(triangle_size(corners(cut->mesh, i)).longest_side, 3);
        sums[cut->origin[i]] += area_vector(cut->mesh, i);
        if (i < box.triangles.size()) {
            EXPECT_EQ(cut->origin[i], i);
        }
    }
    for (std::uint32_t t = 0; t < box.triangles.size(); ++t)
        EXPECT_EQ(sums[t], area_vector(box, t)) << t;
}

TEST(MeshCut, AClosedMeshStaysClosed) {
    for (const double longest : {20.1, 3.0, 0.7})
        for (const std::vector<std::uint32_t>& seeds :
             {std::vector<std::uint32_t>{}, std::vector<std::uint32_t>{5}}) {
            const auto cut = cut_triangles(long_box(), seeds, longest, many);
            ASSERT_TRUE(cut);
            EXPECT_TRUE(mesh_facts(cut->mesh).closed()) << longest;
        }
    // The same with three vertices of its own for each triangle.
    Mesh soup;
    const Mesh box = long_box();
    for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const Vec3& corner : corners(box, t)) soup.vertices.push_back(corner);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_TRUE(mesh_facts(cut_triangles(soup, {}, 3, many)->mesh).closed());
}

TEST(MeshCut, OnlyTrianglesThatShareLongSidesWithASeedAreCut) {
    // Two strips along x that share no side; triangles 0 and 1 share a long side.
    Mesh mesh;
    for (const double y : {0.0, 1.0, 5.0, 6.0})
        for (const double x : {0.0, 10.0}) mesh.vertices.emplace_back(x, y, 0.0);
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}};
    const std::array seeds = {std::uint32_t{1}};
    const auto cut = cut_triangles(mesh, seeds, 6, many);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cut, 2u);
    for (const std::uint32_t origin : cut->origin) EXPECT_TRUE(origin < 4u);
    EXPECT_EQ(std::count_if(cut->origin.begin(), cut->origin.end(),
                            [](std::uint32_t origin) { return origin >= 2; }),
              2);
    EXPECT_EQ(cut->mesh.triangles[2], mesh.triangles[2]);
    // A side of the limit is not longer than it.
    EXPECT_EQ(cut_triangles(mesh, seeds, 10.1, many)->cut, 0u);
}

TEST(MeshCut, EndsAtTheLimitOfPieces) {
    const auto cut = cut_triangles(long_box(), {}, 3, many);
    EXPECT_TRUE(cut_triangles(long_box(), {}, 3, cut->pieces + 4));
    EXPECT_FALSE(cut_triangles(long_box(), {}, 3, cut->pieces - 1));
    for (const double longest : {1e-9, 1e-17, 1e-300})
        EXPECT_FALSE(cut_triangles(long_box(), {}, longest, 1000)) << longest;
}

TEST(MeshCut, ASideBetweenNeighboringNumbersIsKept) {
    Mesh mesh;
    mesh.vertices = {Vec3(1, 0, 0), Vec3(1 + 0x1p-52, 0, 0), Vec3(1, 0x1p-53, 0)};
    mesh.triangles = {{0, 1, 2}};
    const auto cut = cut_triangles(mesh, {}, 0x1p-60, many);
    ASSERT_TRUE(cut);
    EXPECT_LT(cut->mesh.triangles.size(), many);
}

}  // namespace
}  // namespace scb
