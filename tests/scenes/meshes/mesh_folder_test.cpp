#include "scenes/meshes/mesh_folder.h"

#include <sys/stat.h>

#include "core/platform/input_files.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

TEST(MeshFolder, HasTheRegularFilesInAndBelowIt) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path / "near/below");
    const std::string mesh = folder.write("near/mesh.gltf", ""),
                      beside = folder.write("near/a.bin", ""),
                      below = folder.write("near/below/b.bin", ""),
                      outside = folder.write("c.bin", ""), likewise = folder / "nearby.bin";
    folder.write("nearby.bin", "");
    EXPECT_TRUE(side_file(beside, mesh));
    EXPECT_TRUE(side_file(below, mesh));
    EXPECT_TRUE(side_file(folder / "near/below/../a.bin", mesh));
    EXPECT_FALSE(side_file(outside, mesh));
    EXPECT_FALSE(side_file(likewise, mesh));
    EXPECT_FALSE(side_file(folder / "near/../c.bin", mesh));
    EXPECT_FALSE(side_file(folder / "near/gone.bin", mesh));
    EXPECT_FALSE(side_file(folder / "near/below", mesh));
    EXPECT_FALSE(side_file("/dev/zero", mesh));
    fs::create_symlink(outside, folder / "near/link.bin");
    fs::create_symlink("below/b.bin", folder / "near/good.bin");
    EXPECT_FALSE(side_file(folder / "near/link.bin", mesh));
    EXPECT_TRUE(side_file(folder / "near/good.bin", mesh));
    ASSERT_EQ(::mkfifo((folder / "near/pipe").c_str(), 0600), 0);
    EXPECT_FALSE(side_file(folder / "near/pipe", mesh));
    EXPECT_FALSE(side_file("mesh_folder_test.gone", "mesh.gltf"));
}

TEST(MeshFolder, KnowsNamesThatAreUris) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "my%20arms");
    const std::string mesh = folder.write("my%20arms/mesh.gltf", ""),
                      spaced = folder.write("my%20arms/a b.bin", ""),
                      percent = folder.write("my%20arms/c%2e.bin", "");
    folder.write("my%20arms/d", "");
    EXPECT_EQ(side_file(folder / "my%20arms/a%20b.bin", mesh), spaced);
    EXPECT_EQ(side_file(folder / "my%20arms/c%2e.bin", mesh), percent);
    for (const char* name : {"a%2b.bin", "d%00", "d%0a", "d%", "%6", "a%2", "%2e%2e/my%20arms.bin"})
        EXPECT_FALSE(side_file(folder / ("my%20arms/" + std::string(name)), mesh)) << name;
}

/// A triangle whose buffer has a file of its own.
std::string gltf_with(const std::string& uri) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": ")" +
           uri + "\"}]}";
}

TEST(MeshFolder, IsWhereBuffersAreReadFrom) {
    const TemporaryFolder folder;
    std::string bytes;
    for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    fs::create_directories(folder.path / "near/below");
    for (const char* name : {"near/a.bin", "near/a b.bin", "near/below/c.bin"})
        folder.write(name, bytes);
    const std::string outside = folder.write("b.bin", bytes);
    const auto load = [&](const std::string& uri) {
        return load_mesh(folder.write("near/mesh.gltf", gltf_with(uri)));
    };
    for (const char* uri : {"a.bin", "./a.bin", "below/../a.bin", "below/c.bin", "a b.bin",
                            "a%20b.bin", R"(below\\c.bin)"})
        EXPECT_EQ(load(uri).triangles.size(), 1u) << uri;
    // Nothing that is written may replace them.
    expect_in("near/below/c.bin",
              refusal([&] { refuse_input(folder / "near/below/c.bin", "--out"); }));
    ASSERT_EQ(::mkfifo((folder / "near/pipe").c_str(), 0600), 0);
    // The last ones are not there; assimp would take near/a.bin instead.
    for (const std::string& uri :
         {std::string("../b.bin"), std::string("pipe"), outside, std::string("/dev/zero"),
          std::string("gone.bin"), std::string("../a.bin"), std::string("gone/a.bin"),
          folder / "gone/a.bin", folder / "near/a.bin", std::string("http://host/a.bin")})
        expect_in("which is not a regular file in the folder of the mesh; put a copy there",
                  refusal([&] { load(uri); }));
    // A part of this path is another one, of the length of the name.
    fs::create_directories(folder.path / "usr/lib");
    const std::string mesh = folder.write("usr/lib/mesh.gltf", gltf_with("ab.bin"));
    expect_in("names \"ab.bin\", which is not", refusal([&] { load_mesh(mesh); }));
}

}  // namespace
}  // namespace scb::scenes
