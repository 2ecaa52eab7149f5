#include "scenes/shapes/procedural.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TEST(Icosphere, HasTheCountsOfTable2AndIsClosed) {
    for (const auto& [n, vertices, triangles] :
         {std::tuple{0, 12u, 20u}, {1, 42u, 80u}, {5, 10242u, 20480u}, {6, 40962u, 81920u}}) {
        const Mesh mesh = icosphere(n, 0.95);
        EXPECT_EQ(mesh.vertices.size(), vertices);
        EXPECT_EQ(mesh.triangles.size(), triangles);
        expect_closed(mesh);
    }
}

TEST(Icosphere, HasItsVerticesOnTheSphereAndFacesOutwards) {
    const Mesh mesh = icosphere(4, 0.95);
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR(std::sqrt(squared_norm(v)), 0.95, 1e-15);
    EXPECT_NEAR(signed_volume6(mesh), 8 * std::numbers::pi * 0.95 * 0.95 * 0.95, 0.1);
}

TEST(Icosphere, ScalesTheUnitSphereAtTheEnd) {
    const Mesh unit = icosphere(3, 1), small = icosphere(3, 0.95);
    for (std::size_t i = 0; i < unit.vertices.size(); ++i)
        EXPECT_EQ(Vec3(unit.vertices[i] * 0.95), small.vertices[i]);
}

TEST(Icosphere, RefusesWhatItCannotMake) {
    expect_in("subdivisions is 40; give 0 to 9", refusal([] { icosphere(40, 1); }));
    expect_in("subdivisions is -1", refusal([] { icosphere(-1, 1); }));
    expect_in("radius is 0;", refusal([] { icosphere(1, 0); }));
    expect_in("radius is nan;",
              refusal([] { icosphere(1, std::numeric_limits<double>::quiet_NaN()); }));
}

TEST(BoxMesh, IsClosedWithSharedVertices) {
    for (const int n : {1, 2, 5}) {
        const Mesh mesh = box_mesh({{1, 2, 4}, n});
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(12 * n * n));
        EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>(6 * n * n + 2));
        expect_closed(mesh);
        EXPECT_NEAR(signed_volume6(mesh), 48, 1e-12);
        const Box box = bounding_box(mesh);
        EXPECT_EQ(box.lower, Vec3(-0.5, -1, -2));
        EXPECT_EQ(box.upper, Vec3(0.5, 1, 2));
    }
}

TEST(PlaneMesh, IsAGridThatFacesUp) {
    const Mesh mesh = plane_mesh({4, 2, 8, 3});
    EXPECT_EQ(mesh.vertices.size(), 36u);
    EXPECT_EQ(mesh.triangles.size(), 48u);
    double area2 = 0;
    for (const Triangle& t : mesh.triangles) {
        EXPECT_GT(area2_from_above(mesh, t), 0);
        area2 += area2_from_above(mesh, t);
    }
    EXPECT_NEAR(area2, 16, 1e-12);
    expect_in("triangles", refusal([] { plane_mesh({1, 1, 8000000, 8000000}); }));
}

TEST(CylinderMesh, IsClosedWhenCapped) {
    const Mesh mesh = cylinder_mesh({0.5, 3, 24, 4, true});
    EXPECT_EQ(mesh.triangles.size(), 24u * (2 * 4 + 2));
    expect_closed(mesh);
    const double area = 0.5 * 24 * 0.25 * std::sin(2 * std::numbers::pi / 24);
    EXPECT_NEAR(signed_volume6(mesh), 6 * area * 3, 1e-12);
    EXPECT_EQ(cylinder_mesh({0.5, 3, 24, 4, false}).triangles.size(), 24u * 8);
    expect_in("sides is 2", refusal([] { cylinder_mesh({1, 1, 2, 1, true}); }));
}

TEST(CylinderMesh, WithOneSegmentHasLongThinTriangles) {
    const Mesh mesh = cylinder_mesh({0.1, 10, 64, 1, false});
    const Triangle& t = mesh.triangles[0];
    const double width = std::sqrt(squared_norm(mesh.vertices[t[1]] - mesh.vertices[t[0]]));
    EXPECT_GT(10 / width, 100);
}

TEST(ConeMesh, IsClosedWhenCapped) {
    for (const int segments : {1, 5}) {
        const Mesh mesh = cone_mesh({0.5, 3, 24, segments, true});
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(24 * (2 * (segments - 1) + 2)));
        expect_closed(mesh);
        const double area = 0.5 * 24 * 0.25 * std::sin(2 * std::numbers::pi / 24);
        EXPECT_NEAR(signed_volume6(mesh), 6 * area * 3 / 3, 1e-12);
    }
}

TEST(SoupMesh, StaysInItsCubeAndFollowsItsSeed) {
    const Mesh mesh = soup_mesh({500, 2, 0.1, 7});
    EXPECT_EQ(mesh.vertices.size(), 1500u);
    EXPECT_EQ(mesh.triangles.size(), 500u);
    const Box box = bounding_box(mesh);
    EXPECT_LE(box.upper.maxCoeff(), 1.05);
    EXPECT_GE(box.lower.minCoeff(), -1.05);
    EXPECT_EQ(mesh.vertices, soup_mesh({500, 2, 0.1, 7}).vertices);
    EXPECT_NE(mesh.vertices, soup_mesh({500, 2, 0.1, 8}).vertices);
}

/// FNV-1a over the bits of every coordinate and index: any change of order or rounding shows.
std::uint64_t shape_fingerprint(const Mesh& mesh) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&hash](const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    };
    for (const Vec3& v : mesh.vertices) add(v.data(), 3 * sizeof(double));
    for (const Triangle& t : mesh.triangles) add(t.data(), sizeof(t));
    return hash;
}

TEST(ProceduralMeshes, AreTheSameBitsOnEveryCompilerAndMachine) {
    EXPECT_EQ(shape_fingerprint(icosphere(5, 0.95)), 4270729355449024621u);
    EXPECT_EQ(shape_fingerprint(soup_mesh({1000, 1, 0.1, 1})), 6495805808965332008u);
    EXPECT_EQ(shape_fingerprint(cylinder_mesh({0.2, 4, 96, 3, true})), 62583323304710245u);
    EXPECT_EQ(shape_fingerprint(cone_mesh({0.5, 1, 96, 12, true})), 5720439666932453704u);
    EXPECT_EQ(shape_fingerprint(box_mesh({{1, 2, 3}, 7})), 598532752019718569u);
    EXPECT_EQ(shape_fingerprint(plane_mesh({2, 2, 48, 48})), 5204644592778681662u);
}

}  // namespace
}  // namespace scb::scenes
