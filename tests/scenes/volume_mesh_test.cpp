#include "scenes/volume_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace scb {
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

TEST(VolumeMesh, OfABoxIsExact) {
    Obb box{{1, 1, 1}, Mat3::Identity(), {1, 2, 3}};
    const Mesh mesh = volume_mesh(box, 8);
    EXPECT_TRUE(closed(mesh));
    EXPECT_DOUBLE_EQ(area_of(mesh), surface_area(box));
    EXPECT_DOUBLE_EQ(volume_of(mesh), volume(box));
}

TEST(VolumeMesh, OfAFlatScbIsADiscAndOfAPointNothing) {
    const Mesh disc = volume_mesh(Scb{{0, 0, 0}, 2, Vec3::UnitX(), 0, 0}, 64);
    EXPECT_NEAR(area_of(disc), 2 * M_PI * 4, 0.1);
    for (const Vec3& v : disc.vertices) EXPECT_EQ(v[0], 0);
    EXPECT_TRUE(volume_mesh(Scb{{0, 0, 0}, 0, Vec3::UnitX(), 0, 0}, 64).triangles.empty());
}

}  // namespace
}  // namespace scb
