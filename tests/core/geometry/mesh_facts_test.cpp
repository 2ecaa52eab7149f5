#include "core/geometry/mesh_facts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

/// Eight triangles of equal sides, about `center`.
Mesh octahedron(const Vec3& center = Vec3::Zero()) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            mesh.vertices.push_back(center + sign * Vec3::Unit(axis));
    for (const std::uint32_t x : {0u, 1u})
        for (const std::uint32_t y : {2u, 3u})
            for (const std::uint32_t z : {4u, 5u}) mesh.triangles.push_back({x, y, z});
    return mesh;
}

/// Without shared vertices, as a soup has them.
Mesh soup_of(const Mesh& mesh) {
    Mesh soup;
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) soup.vertices.push_back(mesh.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

TEST(MeshFacts, OfAClosedSurfaceWhateverItsIndices) {
    const Mesh solid = octahedron();
    for (const Mesh& mesh : {solid, soup_of(solid)}) {
        const MeshFacts facts = mesh_facts(mesh);
        EXPECT_EQ(facts.triangles, 8u);
        EXPECT_EQ(facts.components, 1u);
        EXPECT_EQ(facts.degenerate, 0u);
        EXPECT_EQ(facts.duplicates, 0u);
        EXPECT_TRUE(facts.closed());
        EXPECT_EQ(facts.slenderness[0], 8u);
        EXPECT_EQ(facts.slender(), 0u);
        EXPECT_NEAR(facts.median_slenderness, 2 / std::sqrt(3.0), 1e-12);
    }
}

TEST(MeshFacts, CountPartsThatAreApartAndTrianglesThatAreThereTwice) {
    Mesh mesh = octahedron();
    append(mesh, octahedron(Vec3(5, 0, 0)));
    append(mesh, octahedron(Vec3(5, 0, 0)));
    std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.components, 2u);
    EXPECT_EQ(facts.duplicates, 8u);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.box.upper[0], 6);
}

TEST(MeshFacts, CountEdgesOfOneTriangleAndOfMoreThanTwo) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {9, 9, 9}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.crowded_edges, 1u);
    EXPECT_EQ(facts.open_edges, 6u);
    EXPECT_FALSE(facts.closed());
    EXPECT_EQ(facts.components, 1u);
    EXPECT_EQ(facts.box.upper, Vec3(1, 1, 1));
}

// A triangle of three corners on one line, where one side divides an edge and the other does not.
TEST(MeshFacts, CountTheEdgesOfDegenerateTrianglesWithThreeCorners) {
    Mesh mesh = octahedron();
    // The edge from 0 to 2 is divided at 6 on one side.
    mesh.vertices.emplace_back(0.5, 0.5, 0);
    const Triangle whole = mesh.triangles[0];
    ASSERT_EQ(whole, (Triangle{0, 2, 4}));
    mesh.triangles[0] = {0, 6, 4};
    mesh.triangles.push_back({6, 2, 4});
    EXPECT_EQ(mesh_facts(mesh).open_edges, 3u);
    mesh.triangles.push_back({0, 2, 6});
    EXPECT_EQ(mesh_facts(mesh).degenerate, 1u);
    EXPECT_TRUE(mesh_facts(mesh).closed());
    mesh.triangles.push_back({0, 0, 2});
    EXPECT_EQ(mesh_facts(mesh).degenerate, 2u);
    EXPECT_TRUE(mesh_facts(mesh).closed());
}

TEST(MeshFacts, SortSlenderTrianglesByTheirClass) {
    Mesh mesh;
    const auto add = [&](double length, double height) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const double z = first;
        mesh.vertices.insert(mesh.vertices.end(),
                             {{0, 0, z}, {length, 0, z}, {length / 2, height, z}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    add(1, 0.5);    // 2
    add(8, 2);      // 4: the next class begins with its limit
    add(5, 0.1);    // 50
    add(7, 0.07);   // 100
    add(1, 0.002);  // 500
    add(1, 1e-4);   // 10000
    add(1, 0);      // degenerate
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.slenderness, (std::array<std::size_t, 6>{1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(facts.degenerate, 1u);
    EXPECT_EQ(facts.slender(), 4u);
    EXPECT_EQ(facts.longest_slender, 3u);
    EXPECT_EQ(facts.longest_slender_side, 7);
    EXPECT_EQ(facts.components, 7u);
    EXPECT_DOUBLE_EQ(facts.median_slenderness, 100);
}

TEST(PlacedBox, IsTheBoxOfTheMovedVerticesThatTrianglesUse) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {100, 100, 100}};
    mesh.triangles = {{0, 1, 2}};
    Pose pose;
    pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
    pose.translation = Vec3(10, 0, 0);
    const Box box = bounding_box(mesh, pose);
    EXPECT_EQ(box.lower, Vec3(9, 0, 0));
    EXPECT_EQ(box.upper, Vec3(10, 1, 1));
}

TEST(GapBetween, IsSignedAlongEachAxisAndNothingWhereBoxesOverlapOrTouch) {
    const Box unit{Vec3(0, 0, 0), Vec3(1, 1, 1)}, there{Vec3(3, -5, 1), Vec3(4, -2, 2)};
    EXPECT_EQ(gap_between(unit, there), Vec3(2, -2, 0));
    EXPECT_EQ(gap_between(there, unit), Vec3(-2, 2, 0));
    EXPECT_EQ(gap_between(unit, unit), Vec3(0, 0, 0));
}

}  // namespace

}  // namespace scb
