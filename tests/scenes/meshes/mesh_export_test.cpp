#include "scenes/meshes/mesh_export.h"

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

ExportPart part(const std::string& name, double x) {
    return {name, {{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}, {{0, 1, 2}}}, {1, 0.5f, 0}};
}

std::string encoded(const std::vector<ExportPart>& parts, const std::string& file) {
    const std::vector<std::uint8_t> bytes = encode_mesh(parts, file);
    return {bytes.begin(), bytes.end()};
}

TEST(MeshExport, IsReadBackInEveryFormat) {
    const TemporaryFolder folder;
    for (const char* name : {"a.ply", "a.obj", "a.glb", "a.stl"}) {
        SCOPED_TRACE(name);
        const Mesh mesh =
            load_mesh(folder.write(name, encoded({part("A", 0), part("B", 5)}, name)));
        ASSERT_EQ(mesh.triangles.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(mesh.vertices[mesh.triangles[i][k]],
                          part("", i == 0 ? 0 : 5).mesh.vertices[k]);
    }
    expect_in("x.xyz: cannot write '.xyz' files", refusal([] { encode_mesh({}, "x.xyz"); }));
    expect_in("format ascii 1.0", encoded({part("A", 0)}, "a.ply"));
}

TEST(MeshExport, GivesEveryPartOfAGlbANodeAndAMeshOfItsName) {
    const std::string bytes = encoded({part("left", 0), part("right", 5)}, "a.glb");
    std::uint32_t length = 0;
    ASSERT_GT(bytes.size(), 20u);
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    const nlohmann::json document = nlohmann::json::parse(bytes.substr(20, length));
    ASSERT_EQ(document.at("meshes").size(), 2u);
    std::map<std::string, std::string> mesh_of_node;
    for (const auto& node : document.at("nodes"))
        if (node.contains("mesh"))
            mesh_of_node[node.at("name")] =
                document.at("meshes").at(node.at("mesh").get<std::size_t>()).at("name");
    EXPECT_EQ(mesh_of_node,
              (std::map<std::string, std::string>{{"left", "left"}, {"right", "right"}}));
}

TEST(MeshExport, RefusesCoordinatesThatFloatCannotHold) {
    const double most = std::numeric_limits<float>::max();
    ExportPart large = part("A", 0);
    for (const char* name : {"a.ply", "a.obj", "a.glb", "a.stl"}) {
        large.mesh.vertices[1] = Vec3(most, 0, -most);
        EXPECT_FALSE(encode_mesh({large}, name).empty());
        large.mesh.vertices[1] = Vec3(0, -1e40, 0);
        EXPECT_EQ(refusal([&] {
                      encode_mesh({part("B", 0), large}, name);
                  }),
                  std::string(name) +
                      ": A has the coordinate -1e+40, but mesh files hold at most 3.4e38; scale "
                      "the mesh down.");
        ExportPart tiny = part("A", 0);
        for (Vec3& v : tiny.mesh.vertices) v *= 1e-60;
        EXPECT_NE(refusal([&] {
                      encode_mesh({tiny}, name);
                  }).find("mesh files hold none below 1.2e-38; scale the mesh up."),
                  std::string::npos);
        for (Vec3& v : tiny.mesh.vertices) v *= -1;
        EXPECT_NE(refusal([&] { encode_mesh({tiny}, name); }), "");
        for (Vec3& v : tiny.mesh.vertices) v *= 0;
        EXPECT_FALSE(encode_mesh({tiny}, name).empty());
    }
}

}  // namespace
}  // namespace scb::scenes
