#include "core/hierarchy/mesh_parity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/base/random.h"
#include "core/geometry/mesh_parts.h"
#include "tests/core/box_mesh.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

/// The side of the mesh that the point is on, checked in every order of the axes. Each order has
/// other rays.
PointSide side_of(const Mesh& mesh, const Vec3& point) {
    EXPECT_TRUE(are_closed(joined_triangles(mesh)));
    std::optional<PointSide> found;
    for (int turn = 0; turn < 3; ++turn)
        for (const double sign : {1.0, -1.0}) {
            const auto turned = [&](const Vec3& p) {
                return Vec3(sign * p[turn], sign * p[(turn + 1) % 3], sign * p[(turn + 2) % 3]);
            };
            Mesh other = mesh;
            for (Vec3& v : other.vertices) v = turned(v);
            const Topology topology = build_topology(other);
            const PointSide side = MeshParity(other, topology).side(turned(point));
            EXPECT_EQ(side, found.value_or(side)) << point.transpose() << ", turn " << turn;
            found = side;
        }
    return *found;
}

// The rays go through vertices, edges and diagonals of the faces, and along faces.
TEST(MeshParity, DecidesEachPointOfAGridThroughABox) {
    const Mesh box = box_mesh({0, 0, 0}, {2, 2, 2});
    for (int x = -1; x <= 3; ++x)
        for (int y = -1; y <= 3; ++y)
            for (int z = -1; z <= 3; ++z) {
                const Vec3 p(x, y, z);
                const bool is_out = p.minCoeff() < 0 || p.maxCoeff() > 2;
                const bool is_in = p.minCoeff() > 0 && p.maxCoeff() < 2;
                EXPECT_EQ(side_of(box, p), is_out  ? PointSide::out
                                           : is_in ? PointSide::in
                                                   : PointSide::on)
                    << p.transpose();
            }
}

TEST(MeshParity, TellsTheLastBitFromTheSurface) {
    const Mesh box = box_mesh({0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(side_of(box, {std::nextafter(1, 0), 0.5, 0.5}), PointSide::in);
    EXPECT_EQ(side_of(box, {std::nextafter(1, 2), 0.5, 0.5}), PointSide::out);
    EXPECT_EQ(side_of(box, {5e-324, 5e-324, 5e-324}), PointSide::in);
    EXPECT_EQ(side_of(box, {-5e-324, 5e-324, 5e-324}), PointSide::out);
    // A slope. At x = 1 its height is 4/3, which is not a double.
    Mesh wedge = box_mesh({0, 0, 0}, {3, 1, 1});
    wedge.vertices[5][2] = wedge.vertices[7][2] = 2;
    EXPECT_EQ(side_of(wedge, {1, 0.25, 4.0 / 3}), PointSide::in);  // rounded down
    EXPECT_EQ(side_of(wedge, {1, 0.25, std::nextafter(4.0 / 3, 2)}), PointSide::out);
    EXPECT_EQ(side_of(wedge, {1.5, 0.25, 1.5}), PointSide::on);
}

TEST(MeshParity, TakesTheSpaceBetweenTwoShellsForTheInside) {
    Mesh hollow = box_mesh({0, 0, 0}, {4, 4, 4});
    append(hollow, box_mesh({1, 1, 1}, {3, 3, 3}));
    EXPECT_EQ(side_of(hollow, {0.5, 0.5, 0.5}), PointSide::in);
    EXPECT_EQ(side_of(hollow, {2, 2, 2}), PointSide::out);
    EXPECT_EQ(side_of(hollow, {2, 2, 1}), PointSide::on);
    // What is there twice is there not at all.
    append(hollow, box_mesh({1, 1, 1}, {3, 3, 3}));
    EXPECT_EQ(side_of(hollow, {2, 2, 2}), PointSide::in);
}

TEST(MeshParity, AgreesWithTheBarycentricCoordinatesInATetrahedron) {
    Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        // A tetrahedron: a point is inside where its four barycentric coordinates are positive.
        Mesh mesh;
        for (int i = 0; i < 4; ++i)
            mesh.vertices.emplace_back(random.below(7), random.below(7), random.below(7));
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        const Vec3 p(random.below(7), random.below(7), random.below(7));
        const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
            return dot(cross(Vec3(b - a), Vec3(c - a)), Vec3(d - a));
        };
        const std::vector<Vec3>& v = mesh.vertices;
        const double whole = volume(v[0], v[1], v[2], v[3]);
        if (whole == 0) continue;
        double least = 1;
        for (std::size_t i = 0; i < 4; ++i) {
            std::vector<Vec3> moved = v;
            moved[i] = p;
            least = std::min(least, volume(moved[0], moved[1], moved[2], moved[3]) / whole);
        }
        EXPECT_EQ(side_of(mesh, p), least > 0   ? PointSide::in
                                    : least < 0 ? PointSide::out
                                                : PointSide::on);
    }
}

}  // namespace
}  // namespace scb
