#include "core/hierarchy/bodies_inside.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

/// A tetrahedron about the point, of about that size.
Mesh solid(const Vec3& center, double size) {
    Mesh mesh;
    for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
        mesh.vertices.push_back(center + size * corner);
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return mesh;
}

Mesh with(Mesh mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return mesh;
}

std::array<PartsInside, 2> inside(const Mesh& a, const Mesh& b, const Pose& b_to_a = {}) {
    const Topology of_a = build_topology(a), of_b = build_topology(b);
    return BodiesInside(a, of_a, b, of_b).at(b_to_a);
}

void expect_parts(const PartsInside& found, std::size_t number, std::size_t of) {
    EXPECT_EQ(found.inside, number);
    EXPECT_EQ(found.parts, of);
    EXPECT_FALSE(found.not_judged);
}

TEST(BodiesInside, OfOneWithinTheOtherEitherWay) {
    const Mesh outer = solid({0, 0, 0}, 10), inner = solid({1, 0, 0}, 1);
    const auto [of_outer, of_inner] = inside(outer, inner);
    expect_parts(of_outer, 0, 1);
    expect_parts(of_inner, 1, 1);
    const auto [of_a, of_b] = inside(inner, outer);
    expect_parts(of_a, 1, 1);
    expect_parts(of_b, 0, 1);
}

TEST(BodiesInside, FollowsThePose) {
    const Mesh outer = solid({0, 0, 0}, 10), inner = solid({0, 0, 0}, 1);
    Pose pose;
    // In the box of the other, but beyond its slanted face.
    pose.translation = {-7, -7, -7};
    expect_parts(inside(outer, inner, pose)[1], 0, 1);
    pose.translation = {5, 5, 5};
    expect_parts(inside(outer, inner, pose)[1], 1, 1);
    pose.translation = {100, 0, 0};
    expect_parts(inside(outer, inner, pose)[1], 0, 0);
    // The rotation takes the first of these places to the second.
    pose.rotation << -1, 0, 0, 0, -1, 0, 0, 0, 1;
    pose.translation = {0, 0, 0};
    expect_parts(inside(outer, solid({-5, -5, 5}, 1), pose)[1], 1, 1);
    pose.rotation << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    expect_parts(inside(solid({5, 5, 5}, 1), outer, pose)[0], 0, 1);
}

TEST(BodiesInside, CountsPartsAndSeesCavities) {
    const Mesh hollow = with(solid({0, 0, 0}, 10), solid({0, 0, 0}, 5)),
               three = with(with(solid({0, 0, 0}, 1), solid({8, 8, 8}, 0.5)), solid({50, 0, 0}, 1));
    const auto [of_hollow, of_three] = inside(hollow, three);
    expect_parts(of_hollow, 0, 2);
    expect_parts(of_three, 1, 3);  // one is in the cavity, one in the material
    expect_parts(inside(solid({0, 0, 0}, 20), hollow)[1], 2, 2);
}

TEST(BodiesInside, JudgesNothingByABodyThatIsOpen) {
    Mesh outer = solid({0, 0, 0}, 10);
    outer.triangles.pop_back();
    const auto [of_outer, of_inner] = inside(outer, solid({1, 0, 0}, 1));
    EXPECT_EQ(of_inner.inside, 0u);
    EXPECT_TRUE(of_inner.not_judged);
    EXPECT_FALSE(of_outer.not_judged);  // outside of the box
    // What lies inside may be open.
    expect_parts(inside(outer, solid({0, 0, 0}, 50))[0], 1, 1);
}

// Which a test that misses contacts may leave.
TEST(BodiesInside, DecidesByAVertexThatIsNotOnTheSurface) {
    const Mesh outer = solid({0, 0, 0}, 10);
    Mesh touching = solid({0, 0, 0}, 1);
    touching.vertices[0] = outer.vertices[0];
    expect_parts(inside(outer, touching)[1], 1, 1);
    expect_parts(inside(outer, outer)[1], 0, 1);
}

}  // namespace
}  // namespace scb
