#include "scenes/meshes/mesh_folder.h"

#include <sys/stat.h>

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
    EXPECT_TRUE(is_side_file(beside, mesh));
    EXPECT_TRUE(is_side_file(below, mesh));
    EXPECT_TRUE(is_side_file(folder / "near/below/../a.bin", mesh));
    EXPECT_FALSE(is_side_file(outside, mesh));
    EXPECT_FALSE(is_side_file(likewise, mesh));
    EXPECT_FALSE(is_side_file(folder / "near/../c.bin", mesh));
    EXPECT_FALSE(is_side_file(folder / "near/gone.bin", mesh));
    EXPECT_FALSE(is_side_file(folder / "near/below", mesh));
    EXPECT_FALSE(is_side_file("/dev/zero", mesh));
    fs::create_symlink(outside, folder / "near/link.bin");
    fs::create_symlink("below/b.bin", folder / "near/good.bin");
    EXPECT_FALSE(is_side_file(folder / "near/link.bin", mesh));
    EXPECT_TRUE(is_side_file(folder / "near/good.bin", mesh));
    ASSERT_EQ(::mkfifo((folder / "near/pipe").c_str(), 0600), 0);
    EXPECT_FALSE(is_side_file(folder / "near/pipe", mesh));
    EXPECT_FALSE(is_side_file("mesh_folder_test.gone", "mesh.gltf"));
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
    fs::create_directory(folder.path / "near");
    folder.write("near/a.bin", bytes);
    const std::string outside = folder.write("b.bin", bytes);
    const auto load = [&](const std::string& uri) {
        return load_mesh(folder.write("near/mesh.gltf", gltf_with(uri)));
    };
    EXPECT_EQ(load("a.bin").triangles.size(), 1u);
    ASSERT_EQ(::mkfifo((folder / "near/pipe").c_str(), 0600), 0);
    for (const char* uri : {"../b.bin", "pipe"})
        expect_in("which is not a regular file in the folder of the mesh; put a copy there",
                  refusal([&] { load(uri); }));
    for (const std::string& uri : {outside, std::string("/dev/zero")})
        EXPECT_THROW(load(uri), InputError) << uri;
}

// What a mesh looks like is not read from anywhere; where it is, matters to nobody.
TEST(MeshFolder, IsNotWaitedForWhereMaterialsAreElsewhere) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const char* library : {"pipe", "/dev/zero", "../gone.mtl"}) {
        const std::string obj =
            std::string("mtllib ") + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
        EXPECT_EQ(load_mesh(folder.write("mesh.obj", obj)).triangles.size(), 1u) << library;
    }
}

}  // namespace
}  // namespace scb::scenes
