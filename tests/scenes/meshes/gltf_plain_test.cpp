#include "scenes/meshes/gltf_plain.h"

#include <nlohmann/json.hpp>

#include "scenes/meshes/left_out.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/meshes/sample_mesh.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

/// Bytes of numbers of one type.
template <class T>
std::string raws(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes += raw(static_cast<T>(value));
    return bytes;
}

/// A triangle of positions of that type, with a buffer view each for positions, and for what else
/// is in the buffer; `change` gets the document.
template <class Change>
std::string triangle_gltf(const std::string& positions, std::size_t type, const std::string& more,
                          const Change& change) {
    const std::string bytes = positions + more;
    json document = {
        {"asset", {{"version", "2.0"}}},
        {"extensionsUsed", {"KHR_mesh_quantization"}},
        {"extensionsRequired", {"KHR_mesh_quantization"}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
        {"accessors",
         {{{"bufferView", 0}, {"componentType", type}, {"count", 3}, {"type", "VEC3"}}}},
        {"bufferViews",
         {{{"buffer", 0}, {"byteLength", positions.size()}},
          {{"buffer", 0}, {"byteOffset", positions.size()}, {"byteLength", more.size()}}}},
        {"buffers",
         {{{"byteLength", bytes.size()},
           {"uri", "data:application/octet-stream;base64," + base64(bytes)}}}}};
    change(document);
    return document.dump();
}
std::string triangle_gltf(const std::string& positions, std::size_t type) {
    return triangle_gltf(positions, type, "", [](const json&) {});
}

Mesh mesh_of_gltf(const std::string& text, const std::string& name = "a.gltf") {
    const TemporaryFolder folder;
    return load_mesh(folder.write(name, text));
}

const std::string three_floats = raws<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
const std::vector<Vec3> three_corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(GltfPlain, ReadsQuantizedPositions) {
    const std::vector<Vec3> expected = {{0, 1, 2}, {100, 0, 0}, {0, 90, 7}};
    const std::initializer_list<int> numbers = {0, 1, 2, 100, 0, 0, 0, 90, 7};
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::int8_t>(numbers), 5120)).vertices, expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::uint8_t>(numbers), 5121)).vertices, expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::int16_t>(numbers), 5122)).vertices, expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::uint16_t>(numbers), 5123)).vertices, expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::int16_t>({-3, 0, 0, 1, 0, 0, 0, -300, 0}), 5122))
                  .vertices,
              (std::vector<Vec3>{{-3, 0, 0}, {1, 0, 0}, {0, -300, 0}}));
    // As gltfpack writes them: four numbers, the first three are used.
    const auto strided = [](json& document) { document["bufferViews"][0]["byteStride"] = 8; };
    EXPECT_EQ(
        mesh_of_gltf(triangle_gltf(raws<std::uint16_t>({0, 1, 2, 9, 100, 0, 0, 9, 0, 90, 7, 9}),
                                   5123, "", strided))
            .vertices,
        expected);
}

TEST(GltfPlain, ReadsNormalizedPositions) {
    const auto normalized = [](json& document) { document["accessors"][0]["normalized"] = true; };
    const std::vector<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::uint8_t>({0, 0, 0, 255, 0, 0, 0, 255, 0}), 5121,
                                         "", normalized))
                  .vertices,
              expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 65535, 0}),
                                         5123, "", normalized))
                  .vertices,
              expected);
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(raws<std::int8_t>({-128, -127, 0, 127, 0, 0, 0, 127, 0}),
                                         5120, "", normalized))
                  .vertices,
              (std::vector<Vec3>{{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(
        mesh_of_gltf(triangle_gltf(raws<std::int16_t>({-32768, 0, 0, 32767, 0, 0, 0, 16384, 0}),
                                   5122, "", normalized))
            .vertices[2],
        Vec3(0, static_cast<double>(static_cast<float>(16384 / 32767.0)), 0));
}

TEST(GltfPlain, ReadsSparsePositions) {
    const std::string more = raws<std::uint8_t>({2, 0, 0, 0}) + raws<float>({0, 5, 0});
    const auto sparse = [](std::size_t index_offset, std::size_t count) {
        return [=](json& document) {
            document["bufferViews"][1]["byteLength"] = 16;
            document["accessors"][0]["sparse"] = {
                {"count", count},
                {"indices",
                 {{"bufferView", 1}, {"byteOffset", index_offset}, {"componentType", 5121}}},
                {"values", {{"bufferView", 1}, {"byteOffset", 4}}}};
        };
    };
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(three_floats, 5126, more, sparse(0, 1))).vertices,
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}}));
    const std::string wrong = raws<std::uint8_t>({3, 0, 0, 0}) + raws<float>({0, 5, 0});
    expect_in("mesh 0, primitive 0: a sparse accessor changes element 3 of 3", refusal([&] {
                  mesh_of_gltf(triangle_gltf(three_floats, 5126, wrong, sparse(0, 1)));
              }));
    expect_in("an accessor of 2 elements reaches beyond buffer view 1", refusal([&] {
                  mesh_of_gltf(triangle_gltf(three_floats, 5126, more, sparse(0, 2)));
              }));
}

TEST(GltfPlain, RefusesAnAccessorBeyondItsView) {
    for (const auto& [field, value] : {std::pair("count", 4), std::pair("byteOffset", 4)})
        for (const std::size_t type : {5126u, 5125u, 5122u}) {
            const auto change = [name = field, number = value](json& document) {
                document["accessors"][0][name] = number;
            };
            const std::string positions =
                type == 5122 ? raws<std::int16_t>({0, 0, 0, 1, 0, 0, 0, 1, 0}) : three_floats;
            expect_in(type == 5125 ? "are not float (KHR_mesh_quantization)"
                                   : "positions reach beyond buffer view 0 or its buffer",
                      refusal([&] { mesh_of_gltf(triangle_gltf(positions, type, "", change)); }));
        }
}

TEST(GltfPlain, RefusesWhatIsQuantizedWithoutSayingSo) {
    const auto undeclared = [](json& document) {
        document.erase("extensionsUsed");
        document.erase("extensionsRequired");
    };
    expect_in(
        "its positions are not float (KHR_mesh_quantization), which the file does not declare",
        refusal([&] {
            mesh_of_gltf(triangle_gltf(raws<std::int8_t>({0, 0, 0, 1, 0, 0, 0, 1, 0}), 5120, "",
                                       undeclared));
        }));
}

TEST(GltfPlain, TakesAllNodesThatAreNoChildrenWithoutAScene) {
    const auto two_roots = [](json& document) {
        document.erase("scene");
        document.erase("scenes");
        document["nodes"] = {{{"children", {1}}, {"translation", {0, 0, 1}}},
                             {{"mesh", 0}},
                             {{"mesh", 0}, {"translation", {0, 0, 5}}}};
    };
    const Mesh mesh = mesh_of_gltf(triangle_gltf(three_floats, 5126, "", two_roots));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[3], Vec3(0, 0, 5));
    const auto no_nodes = [](json& document) {
        document["scenes"] = json::array();
        document.erase("scene");
        document.erase("nodes");
    };
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(three_floats, 5126, "", no_nodes)).vertices,
              three_corners);
}

TEST(GltfPlain, PlacesInstances) {
    const std::string more = raws<float>({0, 0, 1, 0, 0, 5}) + raws<std::int8_t>({0, 0, 0, 127}) +
                             raws<std::int8_t>({0, 0, 127, 0});
    const auto instances = [](json& document) {
        document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
        document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        document["nodes"][0]["translation"] = {10, 0, 0};
        document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
            {"TRANSLATION", 1}, {"ROTATION", 2}, {"_ID", 77}};
        document["accessors"].push_back(
            {{"bufferView", 1}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}});
        document["accessors"].push_back({{"bufferView", 1},
                                         {"byteOffset", 24},
                                         {"componentType", 5120},
                                         {"normalized", true},
                                         {"count", 2},
                                         {"type", "VEC4"}});
    };
    const Mesh mesh = mesh_of_gltf(triangle_gltf(three_floats, 5126, more, instances));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices[1], Vec3(11, 0, 1));
    EXPECT_LT((mesh.vertices[4] - Vec3(9, 0, 5)).norm(), 1e-6);
    const auto uneven = [&](json& document) {
        instances(document);
        document["accessors"][2]["count"] = 1;
    };
    expect_in("node 0: the attributes of its instances have 2 and 1 elements",
              refusal([&] { mesh_of_gltf(triangle_gltf(three_floats, 5126, more, uneven)); }));
    const auto none = [&](json& document) {
        instances(document);
        document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"_ID", 1}};
    };
    expect_in("node 0: its instances (EXT_mesh_gpu_instancing) have neither",
              refusal([&] { mesh_of_gltf(triangle_gltf(three_floats, 5126, more, none)); }));
}

TEST(GltfPlain, LeavesOutWhatOnlyShades) {
    const auto shaded = [](json& document) {
        document["extensionsRequired"] = {"KHR_materials_unlit", "KHR_materials_of_tomorrow",
                                          "EXT_materials_bump", "KHR_texture_transform"};
        document["extensionsUsed"] = document["extensionsRequired"];
        document["materials"] = {
            {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 7}}}}}}};
        document["images"] = {{{"uri", "gone.png"}}};
        document["meshes"][0]["primitives"][0]["material"] = 0;
        document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 99;
    };
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(three_floats, 5126, "", shaded)).vertices, three_corners);
}

TEST(GltfPlain, NotesSkinsAndMorphTargets) {
    const auto deformed = [](json& document) {
        document["nodes"][0]["skin"] = 0;
        document["skins"] = {{{"joints", {0}}}};
        document["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
        document["meshes"][0]["weights"] = {1};
    };
    take_left_out();
    EXPECT_EQ(mesh_of_gltf(triangle_gltf(three_floats, 5126, "", deformed)).vertices,
              three_corners);
    const std::vector<std::string> notes = take_left_out();
    ASSERT_EQ(notes.size(), 1u);
    expect_in("a.gltf: its skins and morph targets are left out", notes[0]);
}

TEST(GltfPlain, IsReadByItsContentUnderAnyEnding) {
    const std::string text = triangle_gltf(three_floats, 5126);
    json document = json::parse(text);
    document["buffers"][0].erase("uri");
    std::string chunk = document.dump();
    chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
    const auto size = [](std::size_t bytes) { return raw(static_cast<std::uint32_t>(bytes)); };
    const std::string chunks = size(chunk.size()) + "JSON" + chunk + size(three_floats.size()) +
                               std::string("BIN\0", 4) + three_floats;
    const std::string glb = "glTF" + size(2) + size(12 + chunks.size()) + chunks;
    for (const char* name : {"a.glb", "a.gltf", "a.obj", "a.vrm", "a"})
        EXPECT_EQ(mesh_of_gltf(glb, name).vertices, three_corners) << name;
    for (const char* name : {"a.gltf", "a.glb", "a.vrm"})
        EXPECT_EQ(mesh_of_gltf(text, name).vertices, three_corners) << name;
}

/// A tetrahedron that Draco's encoder has packed, with positions of 16 bits: 0, and 16384 along
/// each axis.
TEST(GltfPlain, ReadsQuantizedPositionsThatDracoHasPacked) {
    json document = json::parse(R"({"asset": {"version": "2.0"},
"extensionsUsed": ["KHR_draco_mesh_compression", "KHR_mesh_quantization"],
"extensionsRequired": ["KHR_draco_mesh_compression", "KHR_mesh_quantization"],
"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{
"attributes": {"POSITION": 1}, "indices": 0, "extensions": {"KHR_draco_mesh_compression":
{"bufferView": 0, "attributes": {"POSITION": 0}}}}]}],
"accessors": [{"componentType": 5123, "count": 12, "type": "SCALAR"},
{"componentType": 5122, "count": 4, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 59}], "buffers": [{"byteLength": 60, "uri":
"data:application/octet-stream;base64,RFJBQ08CAgEAAAAEBAEAAgEAAQMAAwIBAgMBAQADAwAAAQABAQADAwEgASADACCEiIEBAAAAAABAAAAA"}]})");
    const Mesh mesh = mesh_of_gltf(document.dump());
    EXPECT_EQ(mesh.triangles.size(), 4u);
    const Box box = bounding_box(mesh);
    EXPECT_EQ(box.lower, Vec3(0, 0, 0));
    EXPECT_EQ(box.upper, Vec3(16384, 16384, 16384));
    document["accessors"][1]["normalized"] = true;
    expect_in("its positions are normalized (KHR_mesh_quantization) and packed by Draco",
              refusal([&] { mesh_of_gltf(document.dump()); }));
}

}  // namespace
}  // namespace scb::scenes
