#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "scenes/meshes/mesh_file.h"
#include "tests/samples/sample_meshes.h"
#include "tests/scenes/support.h"

// The meshes of scenes/samples/, which the manuals use, are what tests/samples/make_samples writes.

namespace scb::scenes {
namespace {

std::string sample_path(const std::string& name) {
    return std::string(SCB_SOURCE_DIR "/scenes/samples/") + name;
}

std::string sample_text(const std::string& name) {
    std::ifstream file(sample_path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Samples, AreWhatTheGeneratorWrites) {
    EXPECT_TRUE(sample_text("bracket.ply") == samples::ply_text(samples::bracket()));
    EXPECT_TRUE(sample_text("pin.obj") == samples::obj_text(samples::pin()));
}

TEST(Samples, AreReadWithTheTrianglesThatWereWritten) {
    EXPECT_EQ(load_mesh(sample_path("bracket.ply")).triangles.size(),
              samples::bracket().triangles.size());
    EXPECT_EQ(load_mesh(sample_path("pin.obj")).triangles.size(), samples::pin().triangles.size());
}

TEST(Samples, AreClosedSurfacesThatFaceOutward) {
    for (const Mesh& mesh : {samples::bracket(), samples::pin()}) {
        expect_closed(mesh);
        EXPECT_GT(signed_volume6(mesh), 0);
    }
}

TEST(Samples, TheBracketHasTheVolumeOfItsFacesAndHoles) {
    // Areas of regular polygons of n corners on a circle of radius 1.
    const double area32 = 3.121445152258052, area48 = 3.132628613281238;
    const double plate = 140 * 80 - 4 * 81 * area32 - 256 * area48;
    const double lug = 60 * 35 + (900 * area48) / 2 - 144 * area48;
    EXPECT_NEAR(signed_volume6(samples::bracket()) / 6, plate * 10 + 2 * 12 * lug, 1e-6);
}

TEST(Samples, TheBracketHasTheAreaOfItsFacesAndHoles) {
    // Sides of regular polygons of n corners on a circle of radius 1, all of them.
    const double rim32 = 6.273096981091879, rim48 = 6.2787004060937335;
    const double area32 = 3.121445152258052, area48 = 3.132628613281238;
    const double plate = 140 * 80 - 4 * 81 * area32 - 256 * area48;
    const double lug = 60 * 35 + (900 * area48) / 2 - 144 * area48;
    const double walls = 10 * (2 * 140 + 2 * 80 + 4 * 9 * rim32 + 16 * rim48) +
                         2 * 12 * (2 * 35 + 30 * rim48 / 2 + 12 * rim48);
    double area = 0;
    const Mesh mesh = samples::bracket();
    for (const Triangle& t : mesh.triangles) {
        const Vec3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
                   v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        area += std::sqrt(squared_norm(cross(u, v))) / 2;
    }
    EXPECT_NEAR(area, 2 * plate - 2 * 60 * 12 + 4 * lug + walls, 1e-6);
}

}  // namespace
}  // namespace scb::scenes
