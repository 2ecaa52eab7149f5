#include "scenes/meshes/volume_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace scb::scenes {
namespace {

double area_of(const Mesh& mesh) {
    double area = 0;
    for (const Triangle& t : mesh.triangles)
        area += std::sqrt(squared_norm(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                                             mesh.vertices[t[2]] - mesh.vertices[t[0]]))) /
                2;
    return area;
}

// Positive where triangles are counterclockwise seen from outside (the divergence theorem).
double volume_of(const Mesh& mesh) {
    double six = 0;
    for (const Triangle& t : mesh.triangles)
        six += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
    return six / 6;
}

bool closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (count != 1 || opposite == edges.end() || opposite->second != 1) return false;
    }
    return !edges.empty();
}

/// Triangles with two corners in one place, or with (nearly) no area for the size of the mesh.
int degenerate(const Mesh& mesh) {
    int count = 0;
    const double area = area_of(mesh);
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const bool no_area = squared_norm(cross(b - a, c - a)) <= 1e-20 * area * area;
        if (a == b || b == c || c == a || no_area) ++count;
    }
    return count;
}

TEST(VolumeMesh, OfABallHasTwoPolesWithFans) {
    const Ball ball{{1, -2, 3}, 2.5};
    for (const int segments : {3, 4, 8, 33}) {
        const Mesh mesh = volume_mesh(ball, segments);
        const int rings = std::max(2, segments / 2) - 1;
        EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>(rings * segments + 2));
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(2 * rings * segments));
        EXPECT_TRUE(closed(mesh));
        EXPECT_EQ(degenerate(mesh), 0);
    }
    EXPECT_NEAR(volume_of(volume_mesh(ball, 128)), volume(ball), 0.01 * volume(ball));
}

TEST(VolumeMesh, OfCutsAtOrNearAPoleOrACircleHasNoDegenerateTriangles) {
    const Vec3 n = Vec3(1, 2, -2) / 3, c(1, 2, 3);
    for (const double e : {2.0, std::nextafter(2.0, 0.0), 2 * (1 - 1e-13), 1.9, 1e-300, 1e-17, 0.0})
        for (const double f : {-2.0, std::nextafter(-2.0, 0.0), -1.0, -1e-17, 0.0}) {
            const Mesh mesh = volume_mesh(Scb{c, 2, n, e, f}, 32);
            EXPECT_TRUE(closed(mesh)) << e << ' ' << f;
            EXPECT_EQ(degenerate(mesh), 0) << e << ' ' << f;
            EXPECT_NEAR(area_of(mesh), surface_area(Scb{c, 2, n, e, f}), 1.0) << e << ' ' << f;
        }
}

TEST(VolumeMesh, OfAFlatBoxIsARectangleSeenFromBothSides) {
    for (const Vec3& half : {Vec3(0, 2, 3), Vec3(1, 0, 3), Vec3(1, 2, 0), Vec3(1, 2, 1e-20)}) {
        const Obb box{{1, 2, 3}, Mat3::Identity(), half};
        const Mesh mesh = volume_mesh(box, 8);
        EXPECT_EQ(mesh.triangles.size(), 4u);
        EXPECT_TRUE(closed(mesh));
        EXPECT_EQ(degenerate(mesh), 0);
        EXPECT_DOUBLE_EQ(area_of(mesh), surface_area(box));
    }
    EXPECT_TRUE(volume_mesh(Obb{{1, 2, 3}, Mat3::Identity(), {1, 0, 0}}, 8).triangles.empty());
    EXPECT_TRUE(volume_mesh(Obb{{1, 2, 3}, Mat3::Identity(), {0, 0, 0}}, 8).triangles.empty());
}

TEST(VolumeMesh, ApproachesAreaAndVolumeFromInside) {
    const Vec3 n = Vec3(1, 2, -2) / 3;
    for (const Scb& s : {Scb{{1, 2, 3}, 2, n, 1.5, -0.5}, Scb{{1, 2, 3}, 2, n, 2, -2},
                         Scb{{0, 0, 0}, 1, n, 0.9, 0.6}}) {
        const Mesh mesh = volume_mesh(s, 128);
        EXPECT_TRUE(closed(mesh));
        EXPECT_NEAR(area_of(mesh), surface_area(s), 0.01 * surface_area(s));
        EXPECT_NEAR(volume_of(mesh), volume(s), 0.01 * volume(s));
        EXPECT_LT(volume_of(mesh), volume(s));
        for (const Vec3& v : mesh.vertices)
            EXPECT_LE(squared_norm(v - s.c), s.r * s.r * (1 + 1e-12));
    }
}

TEST(VolumeMesh, OfTwoSlabsApproachesAreaAndVolumeFromInside) {
    const Vec3 n = Vec3(1, 2, -2) / 3, m = Vec3(2, 1, 2) / 3, c(1, 2, 3);
    for (const double e : {2.0, 1.7, 0.4, 0.01, 0.0})
        for (const double f : {-2.0, -1.5, -0.2, -1e-3}) {
            for (const Scb2& s : {Scb2{c, 2, {Slab{n, e, f}, Slab{m, 0.9, -0.6}}},
                                  Scb2{c, 2, {Slab{n, e, f}, Slab{m, 2, -2}}},
                                  Scb2{c, 2, {Slab{m, 0.3, 0}, Slab{n, e, f}}}}) {
                const Mesh mesh = volume_mesh(s, 128);
                EXPECT_TRUE(closed(mesh)) << e << ' ' << f;
                EXPECT_NEAR(area_of(mesh), surface_area(s), 0.02 * surface_area(s));
                EXPECT_NEAR(volume_of(mesh), volume(s), 0.02 * volume(s));
                EXPECT_LT(volume_of(mesh), volume(s));
                EXPECT_EQ(degenerate(mesh), 0) << e << ' ' << f;
                const double slop = 1e-12;
                for (const Vec3& v : mesh.vertices) {
                    EXPECT_LE(squared_norm(v - s.c), s.r * s.r * (1 + slop));
                    for (const Slab& slab : s.slabs) {
                        EXPECT_LE(dot(slab.n, v - s.c), slab.e + slop);
                        EXPECT_GE(dot(slab.n, v - s.c), slab.f - slop);
                    }
                }
            }
        }
}

TEST(VolumeMesh, OfAFlatBallOfTwoSlabsIsSeenFromBothSides) {
    const Vec3 n = Vec3(1, 2, -2) / 3, m = Vec3(2, 1, 2) / 3, c(1, 2, 3);
    for (const Scb2& s : {Scb2{c, 2, {Slab{n, 0, 0}, Slab{m, 0.9, -0.6}}},
                          Scb2{c, 2, {Slab{n, 2, -2}, Slab{m, 0, 0}}},
                          Scb2{c, 2, {Slab{n, 0.3, 0}, Slab{m, 0, 0}}}}) {
        const Mesh mesh = volume_mesh(s, 128);
        EXPECT_TRUE(closed(mesh));
        EXPECT_EQ(degenerate(mesh), 0);
        EXPECT_NEAR(area_of(mesh), surface_area(s), 0.01 * surface_area(s));
    }
    EXPECT_TRUE(volume_mesh(Scb2{c, 2, {Slab{n, 0, 0}, Slab{m, 0, 0}}}, 8).triangles.empty());
    EXPECT_TRUE(volume_mesh(Scb2{c, 0, {Slab{n, 0, 0}, Slab{m, 0, 0}}}, 8).triangles.empty());
}

TEST(VolumeMesh, OfABoxIsExact) {
    Obb box{{1, 1, 1}, Mat3::Identity(), {1, 2, 3}};
    const Mesh mesh = volume_mesh(box, 8);
    EXPECT_TRUE(closed(mesh));
    EXPECT_DOUBLE_EQ(area_of(mesh), surface_area(box));
    EXPECT_DOUBLE_EQ(volume_of(mesh), volume(box));
}

/// A rotation that maps no axis to an axis.
Mat3 turned_axes() {
    Mat3 axes;
    axes << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
    return axes;
}

TEST(VolumeMesh, OfATurnedBoxHasItsCorners) {
    const Obb box{{1, 2, 3}, turned_axes(), {1, 2, 3}};
    const Obb flat{{1, 2, 3}, turned_axes(), {1, 0, 3}};
    for (const Obb& of : {box, flat}) {
        const Mesh mesh = volume_mesh(of, 8);
        EXPECT_EQ(mesh.vertices.size(), of.half[1] > 0 ? 8u : 4u);
        for (const Vec3& vertex : mesh.vertices)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(std::abs(dot(Vec3(of.axes.col(axis)), Vec3(vertex - of.center))),
                            of.half[axis], 1e-12);
        EXPECT_TRUE(closed(mesh));
    }
    EXPECT_NEAR(volume_of(volume_mesh(box, 8)), volume(box), 1e-12);
}

TEST(VolumeMesh, OfAPolytopeIsThatOfItsFaces) {
    // A box of 2, 4 and 6 about (1, 2, 3) that knows its faces.
    ConvexShape box{{1, 2, 3}, 0, Mat3::Identity(), {}, {}};
    box.support_point = [](const Vec3& d) {
        return Vec3(std::copysign(1, d[0]), std::copysign(2, d[1]), std::copysign(3, d[2]));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            box.faces.push_back({Vec3(sign * Vec3::Unit(axis)), axis + 1.0});
    const Mesh mesh = volume_mesh(box, 8);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume_of(mesh), 2 * 4 * 6, 1e-12);
    for (const Vec3& vertex : mesh.vertices)
        EXPECT_NEAR((vertex - box.center).cwiseAbs()[2], 3, 1e-12);
}

TEST(VolumeMesh, OfARoundShapeIsAboutIt) {
    const ConvexShape ball{
        {1, 2, 3}, 0.5, Mat3::Identity(), [](const Vec3&) { return Vec3(Vec3::Zero()); }, {}};
    const Mesh mesh = volume_mesh(ball, 64);
    EXPECT_TRUE(closed(mesh));
    for (const Vec3& vertex : mesh.vertices)
        EXPECT_GE(squared_norm(vertex - ball.center), 0.25 * (1 - 1e-9));
    const double exact = volume(Ball{ball.center, ball.rounding});
    EXPECT_GT(volume_of(mesh), exact);
    EXPECT_NEAR(volume_of(mesh), exact, 0.05 * exact);
}

TEST(VolumeMesh, OfAFlatScbIsADiscAndOfAPointNothing) {
    const Mesh disc = volume_mesh(Scb{{0, 0, 0}, 2, Vec3::UnitX(), 0, 0}, 64);
    EXPECT_NEAR(area_of(disc), 2 * M_PI * 4, 0.1);
    for (const Vec3& v : disc.vertices) EXPECT_EQ(v[0], 0);
    EXPECT_TRUE(volume_mesh(Scb{{0, 0, 0}, 0, Vec3::UnitX(), 0, 0}, 64).triangles.empty());
}

}  // namespace
}  // namespace scb::scenes
