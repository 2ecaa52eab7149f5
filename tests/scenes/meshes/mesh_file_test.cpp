#include "scenes/meshes/mesh_file.h"

#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

#include "tests/scenes/meshes/sample_mesh.h"
#include "tests/stored_zip.h"

namespace scb::scenes {
namespace {

std::string corner_line(const std::string& start, const Vec3& v) {
    return start + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) +
           "\n";
}

std::string corner_lines(const std::string& start) {
    std::string text;
    for (const Vec3& v : sample_mesh.vertices) text += corner_line(start, v);
    return text;
}

/// `first` is the number of the first corner.
std::string triangle_lines(const std::string& start, std::uint32_t first) {
    std::string text;
    for (const auto& [a, b, c] : sample_mesh.triangles)
        text += start + std::to_string(a + first) + " " + std::to_string(b + first) + " " +
                std::to_string(c + first) + "\n";
    return text;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty float "
           "y\nproperty float z\n"
           "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string text_ply() { return ply_header("ascii") + corner_lines("") + triangle_lines("3 ", 0); }

std::string binary_ply(bool big_endian) {
    std::string bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    const auto add = [&](std::string value) {
        bytes += big_endian ? std::string(value.rbegin(), value.rend()) : value;
    };
    for (const Vec3& v : sample_mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) add(raw(static_cast<float>(v[axis])));
    for (const Triangle& t : sample_mesh.triangles) {
        bytes += '\3';
        for (const std::uint32_t v : t) add(raw(static_cast<std::int32_t>(v)));
    }
    return bytes;
}

std::string obj() {
    return "# made by a test\no first\n" + corner_lines("v ") + triangle_lines("f ", 1);
}

std::string off() {
    return "OFF\n# made by a test\n4 6 0\n" + corner_lines("") + triangle_lines("3 ", 0);
}

std::string text_stl() {
    std::string text = "solid test\n";
    for (const Triangle& t : sample_mesh.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : t) text += corner_line("vertex ", sample_mesh.vertices[v]);
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid test\n";
}

std::string binary_stl() {
    std::string bytes(80, ' ');
    bytes += raw(static_cast<std::uint32_t>(sample_mesh.triangles.size()));
    for (const Triangle& t : sample_mesh.triangles) {
        bytes += std::string(12, '\0');
        for (const std::uint32_t v : t)
            for (int axis = 0; axis < 3; ++axis)
                bytes += raw(static_cast<float>(sample_mesh.vertices[v][axis]));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST(MeshFile, KeepsOrderDegenerateAndDuplicateTrianglesInEveryFormat) {
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("a.ply", text_ply())).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.off", off())).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.gltf", gltf(R"([{"mesh": 0}])"))).vertices.size(), 4u);
    EXPECT_EQ(load_mesh(folder.write("a.stl", text_stl())).vertices.size(), 18u);
}

TEST(MeshFile, JoinsTheObjectsOfOneFile) {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write(
        "two.obj",
        "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n"));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices[mesh.triangles[0][0]], Vec3(0, 0, 0));
    EXPECT_EQ(mesh.vertices[mesh.triangles[1][0]], Vec3(5, 0, 0));
}

TEST(MeshFile, CutsPolygonsInPlaceAndDropsPointsAndLines) {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write("p.obj",
                                             "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\n"
                                             "l 1 2\nf 1 2 3 4\nf 1 2 5\nf 1 2 3 5\np 1\n"));
    EXPECT_EQ(mesh.triangles.size(), 5u);
    double area2 = 0;
    for (const Triangle& t : mesh.triangles) {
        EXPECT_GE(area2_from_above(mesh, t), 0);
        area2 += area2_from_above(mesh, t);
    }
    EXPECT_EQ(area2, 8 + 2 + 4);
}

TEST(MeshFile, ReadsColladaWithANodeTransformAndLeavesItsAxesAlone) {
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
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
        const std::string file = folder / name;
        ASSERT_EQ(exporter.Export(scene, format, file), aiReturn_SUCCESS)
            << exporter.GetErrorString();
        const Mesh mesh = load_mesh(file);
        ASSERT_EQ(mesh.triangles.size(), sample_mesh.triangles.size());
        Vec3 size = bounding_box(mesh).upper - bounding_box(mesh).lower;
        std::sort(size.data(), size.data() + 3);  // 3DS comes out with y up
        EXPECT_LT((size - Vec3(1, 2, 3)).cwiseAbs().maxCoeff(), 1e-5);
    }
}

TEST(MeshFile, ReadsEveryGroupOfARawFile) {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.raw",
                                             "first\n0 0 0 1 0 0 0 1 0\n0 0 0 1 0 0 0 0 1\n"
                                             "second\n0 0 0 1 0 0 0 1 0\n"));
    EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST(MeshFile, TakesRemarksInAPlyHeader) {
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    const Mesh mesh =
        load_mesh(folder.write("u.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n99 99 99\n3 0 1 2\n"));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(bounding_box(mesh).upper, Vec3(1, 1, 0));
}

// assimp frees the picture of the package twice, once the mesh was read.
// assimp takes foreign memory for numbers that are missing.
TEST(MeshFile, RefusesA3mfTransformWithoutTwelveNumbers) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& transform) {
        std::string model = model_of_3mf;
        const std::string item = "<item objectid=\"1\"";
        model.insert(model.find(item) + item.size(), " transform=\"" + transform + "\"");
        return folder.write("a.3mf", package_3mf(model));
    };
    EXPECT_EQ(bounding_box(load_mesh(with("2 0 0  0 2 0 0 0 2 1 0 0"))).upper, Vec3(3, 2, 2));
    for (const char* transform : {"", "1 0 0 0 1 0 0 01  5 0 0", "1 0 0 0 1 0 0 0 1 0 0 0 0"})
        EXPECT_NE(refusal([&] { load_mesh(with(transform)); }).find("in place of 12 numbers"),
                  std::string::npos)
            << transform;
    EXPECT_NE(refusal([&] { load_mesh(with("1 0 0 0 1 0 0 0 1 0 0 x")); }).find("12 words"),
              std::string::npos);
}

TEST(MeshFile, ReadsA3mfPackageWithAThumbnail) {
    const TemporaryFolder folder;
    for (const bool with_thumbnail : {false, true}) {
        const Mesh mesh =
            load_mesh(folder.write("a.3mf", package_3mf(model_of_3mf, with_thumbnail)));
        EXPECT_EQ(mesh.vertices.size(), 4u);
        EXPECT_EQ(mesh.triangles.size(), 4u);
    }
}

TEST(MeshFile, ReadsStlUnderTheEndingStlb) {
    std::string bytes(80, ' ');
    bytes += raw(std::uint32_t{1}) + std::string(12, '\0');
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw(value);
    bytes += std::string(2, '\0');
    const TemporaryFolder folder;
    for (const char* name : {"a.stl", "a.stlb", "a.STLB"})
        EXPECT_EQ(load_mesh(folder.write(name, bytes)).vertices,
                  (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))
            << name;
}

/// A triangle at z = 3.
std::string fbx(int up_axis, int unit) {
    const auto property = [](const char* name, const char* type, const char* label, int value) {
        return "P: \"" + std::string(name) + "\", \"" + type + "\", \"" + label + "\", \"\"," +
               std::to_string(value) + "\n";
    };
    return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\n"
           "FBXVersion: 7400\n}\nGlobalSettings: {\nVersion: 1000\nProperties70: {\n" +
           property("UpAxis", "int", "Integer", up_axis) +
           property("FrontAxis", "int", "Integer", 3 - up_axis) +
           property("UnitScaleFactor", "double", "Number", unit) +
           R"(}
}
Objects: {
Geometry: 100, "Geometry::g", "Mesh" {
Vertices: *9 {
a: 0,0,0,1,0,0,0,2,0
}
PolygonVertexIndex: *3 {
a: 0,1,-3
}
GeometryVersion: 124
}
Model: 200, "Model::m", "Mesh" {
Version: 232
Properties70: {
P: "Lcl Translation", "Lcl Translation", "", "A",0,0,3
}
}
}
Connections: {
C: "OO",200,0
C: "OO",100,200
}
)";
}

// As the manual says.
TEST(MeshFile, AppliesTheUnitOfColladaAlone) {
    const TemporaryFolder folder;
    for (const int unit : {1, 100})
        for (const int up : {1, 2})
            EXPECT_EQ(load_mesh(folder.write("a.fbx", fbx(up, unit))).vertices,
                      (std::vector<Vec3>{{0, 0, 3}, {1, 0, 3}, {0, 2, 3}}));
    std::string model = model_of_3mf;
    const std::string unit = "millimeter";
    model.replace(model.find(unit), unit.size(), "inch");
    EXPECT_EQ(bounding_box(load_mesh(folder.write("a.3mf", package_3mf(model)))).upper,
              Vec3(1, 1, 1));
}

}  // namespace
}  // namespace scb::scenes
