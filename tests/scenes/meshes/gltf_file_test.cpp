#include "scenes/meshes/mesh_file.h"

#include "tests/scenes/meshes/sample_mesh.h"

namespace scb::scenes {
namespace {

/// The four corners as floats, then two lists of indices: 0, 1, 2 and 0, 1, 2, 1, 2, 3.
std::string buffer_of_two() { return corner_floats() + std::string("\0\1\2\0\1\2\1\2\3", 9); }

/// Two meshes, of one triangle on the first three corners and of two on the first `vertices`;
/// `extra` goes into the second one's primitive. The nodes name the second mesh first.
std::string gltf_of_two(int vertices, const std::string& extra = "") {
    const std::string box = R"(, "type": "VEC3", "min": [0, 0, 0], "max": [1, 2, 3]})";
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 1}, {"mesh": 0}], "meshes": [
{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2}]},
{"primitives": [{"attributes": {"POSITION": 1}, "indices": 3)" +
           extra +
           R"(}]}],
"buffers": [{"byteLength": 57, "uri": "data:application/octet-stream;base64,)" +
           base64(buffer_of_two()) +
           R"("}], "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
{"buffer": 0, "byteOffset": 48, "byteLength": 9}], "accessors": [
{"bufferView": 0, "componentType": 5126, "count": 3)" +
           box + R"(, {"bufferView": 0, "componentType": 5126, "count": )" +
           std::to_string(vertices) + box + R"(,
{"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"},
{"bufferView": 1, "byteOffset": 3, "componentType": 5121, "count": 6, "type": "SCALAR"}]})";
}

TEST(MeshFile, AppliesTheTransformsOfANodeAndOfThoseAboveIt) {
    const TemporaryFolder folder;
    const std::string nodes =
        R"([{"children": [1], "scale": [2, 2, 2]}, {"children": [2], "translation": [1, 2, 3]}, {"mesh": 0}])";
    expect_same_triangles(load_mesh(folder.write("a.gltf", gltf(nodes))), Vec3(2, 4, 6), 2);
}

TEST(MeshFile, JoinsInstancesInTheOrderOfTheNodesAndTurnsMirroredOnesOver) {
    const TemporaryFolder folder;
    const std::string nodes =
        R"([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1], "translation": [10, 0, 0]}])";
    const Mesh mesh = load_mesh(folder.write("a.gltf", gltf(nodes)));
    ASSERT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(mesh.vertices[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[5], Vec3(9, 0, 0));
    Mesh first{mesh.vertices, {mesh.triangles.begin(), mesh.triangles.begin() + 4}};
    Mesh second{mesh.vertices, {mesh.triangles.begin() + 6, mesh.triangles.begin() + 10}};
    EXPECT_NEAR(signed_volume6(first), signed_volume6(second), 1e-12);
}

TEST(MeshFile, TakesGltfMeshesInTheOrderOfTheNodes) {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.gltf", gltf_of_two(4)));
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.vertices[mesh.triangles[1][2]], Vec3(0, 0, 3));
}

TEST(MeshFile, RefusesGltfPositionsThatAreNotFloat) {
    const TemporaryFolder folder;
    std::string text = gltf_of_two(4);
    const std::string type = "5126";
    text.replace(text.find(type), type.size(), "5122");
    expect_in("mesh 0, primitive 0: its positions are not float (KHR_mesh_quantization)",
              refusal([&] { load_mesh(folder.write("a.gltf", text)); }));
}

TEST(MeshFile, RefusesAGltfIndexOutOfRangeByName) {
    const TemporaryFolder folder;
    const std::string sentence = "mesh 1, primitive 0: index 5 names vertex 3, but there are 3 ";
    const std::string text = gltf_of_two(3);
    expect_in(sentence, refusal([&] { load_mesh(folder.write("a.gltf", text)); }));
    for (const char* mode : {", \"mode\": 5", ", \"mode\": 6"})
        expect_in(sentence,
                  refusal([&] { load_mesh(folder.write("b.gltf", gltf_of_two(3, mode))); }));

    const std::string start = "data:application/octet-stream;base64,";
    const std::size_t from = text.find(start), to = text.find('"', from);
    std::string bytes = buffer_of_two();
    folder.write("c.bin", bytes);
    const std::string beside = text.substr(0, from) + "c.bin" + text.substr(to);
    expect_in(sentence, refusal([&] { load_mesh(folder.write("c.gltf", beside)); }));

    std::string json = text.substr(0, text.rfind(", \"uri\"", from)) + text.substr(to + 1);
    json += std::string(3 - (json.size() + 3) % 4, ' ');
    bytes += std::string(3, '\0');
    const auto chunk = [](std::uint32_t type, const std::string& data) {
        return raw(static_cast<std::uint32_t>(data.size())) + raw(type) + data;
    };
    const std::string chunks = chunk(0x4e4f534a, json) + chunk(0x004e4942, bytes);
    const std::string glb = "glTF" + raw(std::uint32_t{2}) +
                            raw(static_cast<std::uint32_t>(chunks.size() + 12)) + chunks;
    expect_in(sentence, refusal([&] { load_mesh(folder.write("d.glb", glb)); }));
}

/// The four corners, and a triangle of them whose indices are these bytes; `view` goes into the
/// view of the bytes.
std::string gltf_of_indices(const std::string& component_type, const std::string& indices,
                            const std::string& view = "") {
    const std::string buffer = corner_floats() + indices, bytes = std::to_string(buffer.size());
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"buffers": [{"byteLength": )" +
           bytes + R"(, "uri": "data:application/octet-stream;base64,)" + base64(buffer) +
           R"("}], "bufferViews": [{"buffer": 0, "byteLength": 48},
{"buffer": 0, "byteOffset": 48, "byteLength": )" +
           std::to_string(indices.size()) + view + R"(}], "accessors": [
{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
{"bufferView": 1, "componentType": )" +
           component_type + R"(, "count": 3, "type": "SCALAR"}]})";
}

// 256 has no bit in its lowest byte, and 65536 none in its lowest two.
TEST(MeshFile, ChecksEveryByteOfAGltfIndex) {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& text) { return folder.write("a.gltf", text); };
    const auto shorts = [](std::uint16_t last) {
        return raw(std::uint16_t{1}) + raw(std::uint16_t{3}) + raw(last);
    };
    const auto longs = [](std::uint32_t last) {
        return raw(std::uint32_t{1}) + raw(std::uint32_t{3}) + raw(last);
    };
    for (const std::string& text :
         {gltf_of_indices("5121", std::string("\1\3\2", 3)), gltf_of_indices("5123", shorts(2)),
          gltf_of_indices("5125", longs(2))}) {
        const Mesh mesh = load_mesh(write(text));
        ASSERT_EQ(mesh.triangles, (std::vector<Triangle>{{1, 3, 2}}));
    }
    const auto expect_refusal = [&](const std::string& index, const std::string& text) {
        expect_in("index 2 names vertex " + index + ", but there are 4 vertices",
                  refusal([&] { load_mesh(write(text)); }));
    };
    expect_refusal("4", gltf_of_indices("5121", std::string("\1\3\4", 3)));
    expect_refusal("256", gltf_of_indices("5123", shorts(256)));
    expect_refusal("65536", gltf_of_indices("5125", longs(65536)));
}

TEST(MeshFile, TakesGltfIndicesAsFarApartAsTheirViewSays) {
    const TemporaryFolder folder;
    const std::string stride = ", \"byteStride\": 4";
    const auto load = [&](const std::string& indices) {
        return load_mesh(folder.write("a.gltf", gltf_of_indices("5121", indices, stride)));
    };
    EXPECT_EQ(load("\1\xff\xff\xff\3\xff\xff\xff\2\xff\xff\xff").triangles,
              (std::vector<Triangle>{{1, 3, 2}}));
    expect_in("index 2 names vertex 4", refusal([&] { load("\1\1\1\1\3\1\1\1\4\1\1\1"); }));
}

TEST(MeshFile, ChecksTheIndicesOfGltfBase64ThatIsPadded) {
    const TemporaryFolder folder;
    // One and two bytes behind the indices, for which the code ends with == and =.
    for (const std::string& behind : {std::string(1, '\0'), std::string(2, '\0')}) {
        const auto load = [&](const std::string& indices) {
            return load_mesh(folder.write("a.gltf", gltf_of_indices("5121", indices + behind)));
        };
        EXPECT_EQ(load("\1\3\2").triangles, (std::vector<Triangle>{{1, 3, 2}}));
        expect_in("index 2 names vertex 4", refusal([&] { load("\1\3\4"); }));
    }
}

TEST(MeshFile, TurnsAGltfNodeBeforeItStretchesTheOneAboveIt) {
    const TemporaryFolder folder;
    // A quarter turn about z, from x to y; then x is doubled.
    const std::string nodes = R"([{"children": [1], "scale": [2, 1, 1]},
{"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])";
    const Mesh mesh = load_mesh(folder.write("a.gltf", gltf(nodes)));
    EXPECT_LT((mesh.vertices[1] - Vec3(0, 1, 0)).norm(), 1e-6);
    EXPECT_LT((mesh.vertices[2] - Vec3(-4, 0, 0)).norm(), 1e-6);
    EXPECT_LT((mesh.vertices[3] - Vec3(0, 0, 3)).norm(), 1e-6);
}

TEST(MeshFile, LimitsTheCornersOfAllInstances) {
    const TemporaryFolder folder;
    // 1,000 instances of 100,000 triangles: fewer faces than the limit of 2^28, but more corners.
    const std::size_t indices = 300000;
    const std::string buffer = std::string(36, '\0') + std::string(indices, '\2');
    std::string roots, nodes;
    for (int i = 0; i < 1000; ++i) {
        roots += (i == 0 ? "" : ",") + std::to_string(i);
        nodes += std::string(i == 0 ? "" : ",") + R"({"mesh": 0})";
    }
    const std::string count = std::to_string(indices);
    const std::string file = folder.write(
        "a.gltf",
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [)" + roots +
            R"(]}], "nodes": [)" + nodes +
            R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"buffers": [{"byteLength": )" +
            std::to_string(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
            base64(buffer) + R"("}], "bufferViews": [{"buffer": 0, "byteLength": 36},
{"buffer": 0, "byteOffset": 36, "byteLength": )" +
            count + R"(}], "accessors": [
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 1, "componentType": 5121, "count": )" +
            count + R"(, "type": "SCALAR"}]})");
    expect_in("add up to more than 268435456 vertices or corners",
              refusal([&] { load_mesh(file); }));
}

TEST(MeshFile, TakesGltfPrimitivesWithoutIndicesAndOfOtherModes) {
    const TemporaryFolder folder;
    // Lines are dropped, so their indices harm nobody.
    EXPECT_EQ(load_mesh(folder.write("a.gltf", gltf_of_two(3, ", \"mode\": 1"))).triangles.size(),
              1u);
    std::string text = gltf_of_two(3);
    const std::string indices = ", \"indices\": 3";
    text.replace(text.find(indices), indices.size(), "");
    EXPECT_EQ(load_mesh(folder.write("b.gltf", text)).triangles.size(), 2u);
}

// assimp takes each of them for something else, without a word.
TEST(MeshFile, RefusesAGltfFileThatWouldBeMisread) {
    const std::string good = gltf_of_two(4);
    const auto refused_with = [&](const std::string& part, const std::string& instead) {
        const TemporaryFolder folder;
        std::string text = good;
        text.replace(text.find(part), part.size(), instead);
        const std::string file = folder.write("a.gltf", text);
        const std::string sentence = refusal([&] { load_mesh(file); });
        EXPECT_EQ(sentence.rfind(file + ": ", 0), 0u) << sentence;
        return sentence;
    };
    expect_in("line 1, column", refused_with("\"asset\"", "\"asset\": {}, \"asset\""));
    expect_in("buffer 0: its base64 is damaged", refused_with("base64,AAAA", "base64,AA*A"));
    expect_in("buffers[0].uri", refused_with("data:app", "a.bin\\u0000data:app"));
    expect_in("mesh 0, primitive 0: its positions are not of the type VEC3",
              refused_with("\"type\": \"VEC3\"", "\"type\": \"VEC2\""));
    expect_in("mesh 0, primitive 0: a field that it needs is missing or is of another kind",
              refused_with("\"count\": 3", "\"count\": 1e300"));
    expect_in("nodes[0].matrix: expected 16 numbers",
              refused_with("{\"mesh\": 1}", "{\"mesh\": 1, \"matrix\": [1, 0, 0]}"));
    expect_in("nodes[0].scale[1]: expected a number",
              refused_with("{\"mesh\": 1}", "{\"mesh\": 1, \"scale\": [1, \"2\", 0]}"));
    expect_in("extensionsRequired[1]: the file needs the extension \"EXT_meshopt_compression\"",
              refused_with("\"scene\": 0",
                           "\"scene\": 0, \"extensionsRequired\": [\"KHR_materials_unlit\", "
                           "\"EXT_meshopt_compression\"]"));
}

TEST(MeshFile, RefusesGltfNodesThatAreNoNumbers) {
    const TemporaryFolder folder;
    for (const char* children : {R"(["1"])", "[1.0]", "[-1]"})
        expect_in(
            "nodes[0].children[0]: expected the number of a node", refusal([&] {
                load_mesh(folder.write("a.gltf", gltf(R"([{"children": )" + std::string(children) +
                                                      R"(}, {"mesh": 0}])")));
            }));
    std::string text = gltf_of_two(4);
    const std::string nodes = R"("nodes": [0, 1])";
    text.replace(text.find(nodes), nodes.size(), R"("nodes": ["0"])");
    expect_in("scenes[0].nodes[0]: expected the number of a node",
              refusal([&] { load_mesh(folder.write("b.gltf", text)); }));
}

TEST(MeshFile, RefusesGltfAttributesThatOnlyStartLikePositions) {
    const TemporaryFolder folder;
    for (const char* name : {"POSITION_0", "POSITIONX"}) {
        std::string text = gltf_of_two(4);
        text.replace(text.find("POSITION"), 8, name);
        expect_in(std::string("its attribute \"") + name + "\" would be misread",
                  refusal([&] { load_mesh(folder.write("a.gltf", text)); }));
    }
}

TEST(MeshFile, TakesTheFirstBufferOfAGlbFromItsChunkOnly) {
    const auto number = [](std::size_t value) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
        return bytes;
    };
    const auto glb = [&](std::string text, const std::string& binary) {
        text.resize((text.size() + 3) / 4 * 4, '\0');  // as some writers pad
        std::string chunks = number(text.size()) + "JSON" + text;
        if (!binary.empty()) chunks += number(binary.size()) + std::string("BIN\0", 4) + binary;
        return "glTF" + number(2) + number(12 + chunks.size()) + chunks;
    };
    const std::string named = gltf_of_two(4);
    const std::size_t uri = named.find(", \"uri\"");
    std::string unnamed = named;
    unnamed.erase(uri, named.find("\"}", uri) + 1 - uri);
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("a.glb", glb(unnamed, buffer_of_two() + std::string(3, '\0'))))
                  .triangles.size(),
              3u);
    for (const std::string& binary : {std::string(), std::string(60, '\1')})
        expect_in("buffers[0]: it has a uri, but the first buffer of a .glb",
                  refusal([&] { load_mesh(folder.write("b.glb", glb(named, binary))); }));
}

TEST(MeshFile, SaysThatAGltfFileIsCutOff) {
    const TemporaryFolder folder;
    std::string text = gltf_of_two(3);
    text.resize(text.size() - 3);
    expect_in("the file is cut off", refusal([&] { load_mesh(folder.write("a.gltf", text)); }));
}

}  // namespace
}  // namespace scb::scenes
