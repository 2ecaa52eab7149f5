#include "scenes/mesh_file.h"

#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cstring>

#include "tests/scenes/support.h"

namespace scb {
namespace {

/// Four corners and six triangles: a tetrahedron, one triangle again, and one that repeats a
/// corner.
const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const std::vector<Triangle> triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3},
                                         {2, 0, 3}, {0, 2, 1}, {1, 1, 2}};

template <class T>
std::string raw(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty float "
           "y\nproperty float z\n"
           "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string text_ply() {
    std::string text = ply_header("ascii");
    for (const Vec3& v : corners)
        text +=
            std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
    for (const auto& [a, b, c] : triangles)
        text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    return text;
}

std::string binary_ply(bool big_endian) {
    std::string bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    const auto add = [&](std::string value) {
        bytes += big_endian ? std::string(value.rbegin(), value.rend()) : value;
    };
    for (const Vec3& v : corners)
        for (int axis = 0; axis < 3; ++axis) add(raw(static_cast<float>(v[axis])));
    for (const Triangle& t : triangles) {
        bytes += '\3';
        for (const std::uint32_t v : t) add(raw(static_cast<std::int32_t>(v)));
    }
    return bytes;
}

std::string obj() {
    std::string text = "# made by a test\no first\n";
    for (const Vec3& v : corners)
        text += "v " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " +
                std::to_string(v[2]) + "\n";
    for (const auto& [a, b, c] : triangles)
        text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
                std::to_string(c + 1) + "\n";
    return text;
}

std::string off() {
    std::string text = "OFF\n# made by a test\n4 6 0\n";
    for (const Vec3& v : corners)
        text +=
            std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
    for (const auto& [a, b, c] : triangles)
        text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    return text;
}

std::string text_stl() {
    std::string text = "solid test\n";
    for (const Triangle& t : triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : t)
            text += "vertex " + std::to_string(corners[v][0]) + " " +
                    std::to_string(corners[v][1]) + " " + std::to_string(corners[v][2]) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid test\n";
}

std::string binary_stl() {
    std::string bytes(80, ' ');
    bytes += raw(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles) {
        bytes += std::string(12, '\0');
        for (const std::uint32_t v : t)
            for (int axis = 0; axis < 3; ++axis) bytes += raw(static_cast<float>(corners[v][axis]));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

std::string base64(const std::string& bytes) {
    const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// `nodes` is the JSON of the list of nodes; the first one is the scene's root.
std::string gltf(const std::string& nodes, std::uint16_t last_index = 2) {
    std::string buffer;
    for (const Vec3& v : corners)
        for (int axis = 0; axis < 3; ++axis) buffer += raw(static_cast<float>(v[axis]));
    const std::size_t vertex_bytes = buffer.size();
    for (const Triangle& t : triangles)
        for (const std::uint32_t v : t) buffer += raw(static_cast<std::uint16_t>(v));
    buffer.replace(buffer.size() - 2, 2, raw(last_index));
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" +
           nodes +
           R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "buffers": [{"byteLength": )" +
           std::to_string(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
           base64(buffer) +
           R"("}], "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )" +
           std::to_string(vertex_bytes) + R"(}, {"buffer": 0, "byteOffset": )" +
           std::to_string(vertex_bytes) + R"(, "byteLength": )" +
           std::to_string(buffer.size() - vertex_bytes) +
           R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
              "max": [1, 2, 3]}, {"bufferView": 1, "componentType": 5123, "count": 18, "type": "SCALAR"}]})";
}

/// The four corners as floats, then two lists of indices: 0, 1, 2 and 0, 1, 2, 1, 2, 3.
std::string buffer_of_two() {
    std::string buffer;
    for (const Vec3& v : corners)
        for (int axis = 0; axis < 3; ++axis) buffer += raw(static_cast<float>(v[axis]));
    return buffer + std::string("\0\1\2\0\1\2\1\2\3", 9);
}

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

/// Triangles in file order, corner by corner, whatever vertices the reader repeated.
void expect_same_triangles(const Mesh& mesh, const Vec3& offset = Vec3::Zero(), double scale = 1) {
    ASSERT_EQ(mesh.triangles.size(), triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.vertices[mesh.triangles[t][k]],
                      Vec3(scale * corners[triangles[t][k]] + offset))
                << "triangle " << t << " corner " << k;
}

TEST(MeshFile, KeepsOrderDegenerateAndDuplicateTrianglesInEveryFormat) {
    const TempFolder folder;
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.ply", text_ply()},
        {"b.ply", binary_ply(false)},
        {"c.ply", binary_ply(true)},
        {"d.obj", obj()},
        {"e.off", off()},
        {"f.stl", text_stl()},
        {"g.stl", binary_stl()},
        {"h.gltf", gltf(R"([{"mesh": 0}])")},
    };
    for (const auto& [name, bytes] : files) {
        SCOPED_TRACE(name);
        expect_same_triangles(load_mesh(folder.write(name, bytes)));
    }
}

TEST(MeshFile, SharesVerticesWhereTheFileDoes) {
    const TempFolder folder;
    EXPECT_EQ(load_mesh(folder.write("a.ply", text_ply())).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.off", off())).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.gltf", gltf(R"([{"mesh": 0}])"))).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.stl", text_stl())).vertices.size(), 18u);
}

TEST(MeshFile, AppliesTheTransformsOfANodeAndOfThoseAboveIt) {
    const TempFolder folder;
    const std::string nodes =
        R"([{"children": [1], "scale": [2, 2, 2]}, {"children": [2], "translation": [1, 2, 3]}, {"mesh": 0}])";
    expect_same_triangles(load_mesh(folder.write("a.gltf", gltf(nodes))), Vec3(2, 4, 6), 2);
}

TEST(MeshFile, JoinsInstancesInTheOrderOfTheNodesAndTurnsMirroredOnesOver) {
    const TempFolder folder;
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
    const TempFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.gltf", gltf_of_two(4)));
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.vertices[mesh.triangles[1][2]], Vec3(0, 0, 3));
}

TEST(MeshFile, RefusesAGltfIndexOutOfRangeByName) {
    const TempFolder folder;
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

TEST(MeshFile, LimitsTheCornersOfAllInstances) {
    const TempFolder folder;
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
    const TempFolder folder;
    // Lines are dropped, so their indices harm nobody.
    EXPECT_EQ(load_mesh(folder.write("a.gltf", gltf_of_two(3, ", \"mode\": 1"))).triangles.size(),
              1u);
    std::string text = gltf_of_two(3);
    const std::string indices = ", \"indices\": 3";
    text.replace(text.find(indices), indices.size(), "");
    EXPECT_EQ(load_mesh(folder.write("b.gltf", text)).triangles.size(), 2u);
}

TEST(MeshFile, JoinsTheObjectsOfOneFile) {
    const TempFolder folder;
    const Mesh mesh = load_mesh(folder.write(
        "two.obj",
        "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n"));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices[mesh.triangles[0][0]], Vec3(0, 0, 0));
    EXPECT_EQ(mesh.vertices[mesh.triangles[1][0]], Vec3(5, 0, 0));
}

TEST(MeshFile, CutsPolygonsInPlaceAndDropsPointsAndLines) {
    const TempFolder folder;
    const Mesh mesh = load_mesh(folder.write("p.obj",
                                             "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\n"
                                             "l 1 2\nf 1 2 3 4\nf 1 2 5\nf 1 2 3 5\np 1\n"));
    EXPECT_EQ(mesh.triangles.size(), 5u);
    double area2 = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
                   v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        EXPECT_GE(u[0] * v[1] - u[1] * v[0], 0);
        area2 += u[0] * v[1] - u[1] * v[0];
    }
    EXPECT_EQ(area2, 8 + 2 + 4);
}

TEST(MeshFile, ReadsColladaWithANodeTransformAndLeavesItsAxesAlone) {
    const TempFolder folder;
    const Mesh mesh = load_mesh(folder.write("n.dae", R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="n">
<matrix>1 0 0 10 0 2 0 20 0 0 1 30 0 0 0 1</matrix><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)"));
    ASSERT_EQ(mesh.triangles.size(), 1u);
    const Triangle& t = mesh.triangles[0];
    EXPECT_EQ(mesh.vertices[t[0]], Vec3(10, 20, 30));
    EXPECT_EQ(mesh.vertices[t[1]], Vec3(11, 20, 30));
    EXPECT_EQ(mesh.vertices[t[2]], Vec3(10, 22, 30));
}

TEST(MeshFile, ReadsWhatAssimpExports) {
    const TempFolder folder;
    const std::string source = folder.write("source.ply", text_ply());
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(source, 0);
    ASSERT_NE(scene, nullptr);
    for (const auto& [format, name] : {std::pair{"glb2", "x.glb"},
                                       {"3ds", "x.3ds"},
                                       {"fbxa", "x.fbx"},
                                       {"collada", "x.dae"},
                                       {"x", "x.x"}}) {
        SCOPED_TRACE(format);
        Assimp::Exporter exporter;
        const std::string file = (folder.path / name).string();
        ASSERT_EQ(exporter.Export(scene, format, file), aiReturn_SUCCESS)
            << exporter.GetErrorString();
        const Mesh mesh = load_mesh(file);
        ASSERT_EQ(mesh.triangles.size(), triangles.size());
        Vec3 size = bounding_box(mesh).upper - bounding_box(mesh).lower;
        std::sort(size.data(), size.data() + 3);  // 3DS comes out with y up
        EXPECT_LT((size - Vec3(1, 2, 3)).cwiseAbs().maxCoeff(), 1e-5);
    }
}

TEST(MeshFile, ReadsEveryGroupOfARawFile) {
    const TempFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.raw",
                                             "first\n0 0 0 1 0 0 0 1 0\n0 0 0 1 0 0 0 0 1\n"
                                             "second\n0 0 0 1 0 0 0 1 0\n"));
    EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST(MeshFile, TakesRemarksInAPlyHeader) {
    const TempFolder folder;
    std::string text = text_ply();
    const std::string remark = "Created by Blender3D 247, source file: \n\nhello\n";
    text.insert(text.find("element"), remark);
    EXPECT_EQ(load_mesh(folder.write("a.ply", text)).triangles.size(), 6u);
    for (const char* line : {"elemnt edge 7\n", "prop float q\n", "propertie list uchar int q\n"}) {
        std::string wrong = text_ply();
        wrong.insert(wrong.find("element"), line);
        expect_in("is not a PLY keyword",
                  refusal([&] { load_mesh(folder.write("b.ply", wrong)); }));
    }
}

TEST(MeshFile, KeepsUnusedVerticesOutOfTheBox) {
    const TempFolder folder;
    const Mesh mesh =
        load_mesh(folder.write("u.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n99 99 99\n3 0 1 2\n"));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(bounding_box(mesh).upper, Vec3(1, 1, 0));
}

}  // namespace
}  // namespace scb
