#include <csignal>
#include <cstdlib>
#include <limits>
#include <optional>

#include "core/base/random.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

std::string ply(const std::string& vertices, const std::string& faces, const std::string& body,
                const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

const char* const three = "0 0 0\n1 0 0\n0 1 0\n";

/// Loads bytes under a name; the refusal must name the file and be one line.
std::string refused_file(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    const std::string file = folder.write(name, bytes);
    const std::string sentence = refusal([&] { load_mesh(file); });
    EXPECT_EQ(sentence.rfind(file + ": ", 0), 0u) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_EQ(sentence.empty() ? '.' : sentence.back(), '.') << sentence;
    return sentence.size() > file.size() + 2 ? sentence.substr(file.size() + 2) : sentence;
}

TEST(BadMeshFile, ThatIsMissingOrNoFileIsNamed) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal([] { load_mesh("gone/horse.ply"); }),
              "gone/horse.ply: there is no such file; check the path.");
    EXPECT_EQ(refusal([&] { load_mesh(folder.path); }),
              folder.path.string() + ": this is a directory; name a file in it.");
    expect_in("not a regular file", refusal([] { load_mesh("/dev/null"); }));
    expect_in(": cannot be reached (File name too long); check the path",
              refusal([] { load_mesh(std::string(300, 'a') + ".obj"); }));
}

TEST(BadMeshFile, OfAnUnknownFormatIsToldTheFormats) {
    expect_in(
        "the format is not known; give a mesh as OBJ, PLY, STL, OFF, glTF, GLB, DAE, 3DS, FBX",
        refused_file("notes.xyz", "this is not a mesh\n"));
}

TEST(BadMeshFile, ThatIsEmptyOrRandomIsRefusedInEveryFormat) {
    for (const char* extension : {"obj", "ply", "stl", "off", "gltf", "glb", "dae", "3ds", "fbx",
                                  "x", "ase", "lwo", "ac", "md2"}) {
        SCOPED_TRACE(extension);
        const std::string name = std::string("bad.") + extension;
        expect_in("the file is empty", refused_file(name, ""));
        refused_file(name, "this is not a mesh\nnot 1 2 3\n");
        Random random(42);
        std::string noise;
        for (int i = 0; i < 3000; ++i) noise += static_cast<char>(random.next() & 255);
        refused_file(name, noise);
    }
}

TEST(BadMeshFile, WithNoTriangleIsRefused) {
    expect_in("no triangles", refused_file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"));
    expect_in("no triangles", refused_file("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"));
    expect_in("no triangles", refused_file("none.ply", ply("0", "0", "")));
    expect_in("no triangles", refused_file("points.ply", ply("3", "0", three)));
    expect_in("no triangles", refused_file("none.off", "OFF\n3 0 0\n" + std::string(three)));
}

TEST(BadMeshFile, WithAnIndexOutOfRangeNamesIt) {
    expect_in("face 0 names vertex 7, but there are 3 vertices",
              refused_file("a.ply", ply("3", "1", three + std::string("3 0 1 7\n"))));
    expect_in("face 1 names vertex -1",
              refused_file("b.ply", ply("3", "2", three + std::string("3 0 1 2\n3 0 1 -1\n"))));
    expect_in("face 0 names vertex 3, but there are 3 vertices",
              refused_file("a.off", "OFF\n3 1 0\n" + std::string(three) + "3 0 1 3\n"));
    expect_in("face 0 names vertex -1",
              refused_file("b.off", "OFF 3 1 0\n" + std::string(three) + "3 0 1 -1\n"));
    for (const char* index : {"+2", "0.2e1", "2.0"})
        expect_in(std::string("face 0 names vertex ") + index,
                  refused_file("c.off", "OFF\n3 1 0\n" + std::string(three) + "3 0 1 " + index));
    expect_in("face 0 of the 1 that are declared is missing or broken",
              refused_file("d.off", "OFF\n3 1 0\n" + std::string(three) + "0.3e1 0 1 2\n"));
    for (const char* face : {"1 2 9", "0 1 2", "-1 -2 -9", "1 2 99999999999999"})
        expect_in("index", refused_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf " +
                                                     std::string(face) + "\n"));
}

/// A triangle whose last index is another one.
std::string dae_with(const std::string& index) {
    return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 )" +
           index + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// A triangle, or one of each of these third corners in a chunk of its own.
std::string tds_with(std::uint16_t index, std::optional<std::uint16_t> other = {}) {
    const auto raw16 = [](std::uint16_t value) {
        return std::string{static_cast<char>(value & 255), static_cast<char>(value >> 8)};
    };
    const auto chunk = [&](std::uint16_t id, const std::string& inside) {
        const auto size = static_cast<std::uint16_t>(inside.size() + 6);
        return raw16(id) + raw16(size) + raw16(0) + inside;
    };
    std::string vertices = raw16(3);
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
        vertices.append(reinterpret_cast<const char*>(&value), sizeof value);
    const auto face = [&](std::uint16_t third) {
        return chunk(0x4120, raw16(1) + raw16(0) + raw16(1) + raw16(third) + raw16(0));
    };
    const std::string faces = face(index) + (other ? face(*other) : "");
    const std::string mesh = chunk(0x4100, faces + chunk(0x4110, vertices));
    return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("m\0", 2) + mesh)));
}

TEST(BadMeshFile, WithAnIndexThatAssimpTakesForAnotherIsRefused) {
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("good.dae", dae_with("2"))).triangles.size(), 1u);
    for (const char* index : {"-1", "4294967298", "18446744073709551618", "2x", "1e2", "2.0"})
        expect_in(std::string("index 2 of list 0 of <p> is ") + index,
                  refused_file("a.dae", dae_with(index)));
    refused_file("b.dae", dae_with("3"));
    EXPECT_EQ(load_mesh(folder.write("good.3ds", tds_with(2))).triangles.size(), 1u);
    const char* const names_3 = "mesh 0, face 0 names vertex 3, but there are 3 vertices";
    expect_in(names_3, refused_file("a.3ds", tds_with(3)));
    expect_in(names_3, refused_file("b.3ds", tds_with(3, 2)));
    // Under any name: assimp recognizes the format by the content.
    for (const char* name : {"a.prj", "a.mesh"})
        expect_in(names_3, refused_file(name, tds_with(3)));
    for (const char* name : {"a.xml", "a.mesh"})
        expect_in("of <p> is -1", refused_file(name, dae_with("-1")));
    expect_in("unpack it", refused_file("a.zae", dae_with("2")));
}

TEST(BadMeshFile, WithIndicesWrittenInOtherWaysIsRefused) {
    const auto dae = [](const std::string& open, const std::string& numbers) {
        std::string text = dae_with("2");
        const std::string plain = "<p>0 1 2";
        return text.replace(text.find(plain), plain.size(), open + numbers);
    };
    const TemporaryFolder folder;
    for (const char* open : {"<p >", "<p\nid=\"x\">", "<p id='x' >"}) {
        expect_in("of <p> is -1", refused_file("a.dae", dae(open, "-1 1 2")));
        EXPECT_EQ(load_mesh(folder.write("a.dae", dae(open, "0 1 2"))).triangles.size(), 1u);
    }
    for (const char* numbers : {"<![CDATA[-1 1 2]]>", "&#45;1 1 2", "<!-- --> -1 1 2"})
        expect_in("is not plain numbers", refused_file("a.dae", dae("<p>", numbers)));
    // An OFF file without its first word, and a PLY file by another name.
    expect_in("face 0 names vertex 9",
              refused_file("a.off", "3 1 0\n" + std::string(three) + "3 0 1 9\n"));
    expect_in("is missing or broken",
              refused_file("a.off", "3 2 0\n" + std::string(three) + "3 0 1 2\n"));
    // An OFF file by another name, which assimp goes by the content of.
    expect_in("face 0 names vertex 9",
              refused_file("a.mesh", "OFF\n3 1 0\n" + std::string(three) + "3 0 1 9\n"));
    std::string shouted = ply("30", "1", three + std::string("3 0 1 2\n"));
    shouted.replace(0, 3, "PLY");
    expect_in("vertex", refused_file("a.foo", shouted));
}

TEST(BadMeshFile, WithACoordinateThatIsNotFiniteNamesIt) {
    const std::string nan_line = "0 0 0\nnan 0 0\n0 1 0\n";
    expect_in("vertex 1 of triangle 0 has the coordinate x = nan",
              refused_file("a.ply", ply("3", "1", nan_line + "3 0 1 2\n")));
    expect_in("x = nan", refused_file("a.off", "OFF\n3 1 0\n" + nan_line + "3 0 1 2\n"));
    expect_in("x = nan", refused_file("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"));
    expect_in("x = 1e+300", refused_file("b.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n"));
    std::string body;
    for (int i = 0; i < 9; ++i) {
        const float value =
            i == 5 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i);
        body.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    body += '\3';
    for (const std::int32_t index : {0, 1, 2})
        body.append(reinterpret_cast<const char*>(&index), sizeof index);
    expect_in("vertex 1 of triangle 0 has the coordinate z = nan",
              refused_file("b.ply", ply("3", "1", body, "binary_little_endian")));
}

TEST(BadMeshFile, WhosePlyHeaderLiesIsRefusedBeforeMemoryIsSpent) {
    expect_in("vertex 3 of the 200000000", refused_file("a.ply", ply("200000000", "1", three)));
    expect_in("face 1 of the 200000000",
              refused_file("b.ply", ply("3", "200000000", three + std::string("3 0 1 2\n"))));
    expect_in(
        "vertex 2 of the 200000000",
        refused_file("c.ply", ply("200000000", "1", std::string(30, 'x'), "binary_big_endian")));
    expect_in("declares 4000000000 elements of the kind vertex, and at most 268435456 are read",
              refused_file("h.ply", ply("4000000000", "1", three)));
    expect_in("header line 3: element vertex needs a count",
              refused_file("d.ply", ply("-3", "1", three)));
    expect_in("header line 3: element vertex needs a count",
              refused_file("e.ply", ply("99999999999999999999999", "1", three)));
    expect_in("face 0", refused_file("f.ply", ply("3", "1", three + std::string("200 0 1 2\n"))));
    expect_in("face 0 has a list with a length",
              refused_file("g.ply", ply("3", "1", three + std::string("-3 0 1 2\n"))));
    expect_in("vertex 3 of the 4000000000",
              refused_file("a.off", "OFF\n4000000000 1 0\n" + std::string(three)));
}

TEST(BadMeshFile, WhosePlyHeaderIsBrokenNamesTheLine) {
    expect_in("header line 2: the file ends before end_header", refused_file("a.ply", "ply\n"));
    expect_in("header line 1: a PLY file starts", refused_file("b.ply", "plx\nend_header\n"));
    expect_in("header line 2: the format must be",
              refused_file("c.ply", "ply\nformat utf 1.0\nend_header\n"));
    expect_in("header line 3: a property stands before",
              refused_file("d.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n"));
    expect_in(
        "the type \"floa\" is not",
        refused_file("e.ply",
                     "ply\nformat ascii 1.0\nelement vertex 1\nproperty floa x\nend_header\n"));
    expect_in(
        "no property y",
        refused_file("f.ply",
                     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"));
    expect_in(
        "without any property",
        refused_file("g.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n1\n"));
}

TEST(BadMeshFile, WithMoreThanItsPlyHeaderDeclaresIsRefused) {
    const std::string faces = three + std::string("3 0 1 2\n");
    expect_in("something follows all that the header declares",
              refused_file("a.ply", ply("3", "1", faces + "3 0 2 1\n")));
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("b.ply", ply("3", "1", faces + " \r\n\n"))).triangles.size(),
              1u);
}

TEST(BadMeshFile, ThatIsCutOffAnywhereIsRefused) {
    const std::string text = ply("3", "2", three + std::string("3 0 1 2\n3 2 1 0\n"));
    for (std::size_t length = 1; length + 3 < text.size(); length += 3)
        refused_file("cut.ply", text.substr(0, length));
    std::string bytes = ply("3", "2", "", "binary_little_endian") + std::string(36, '\0');
    for (int face = 0; face < 2; ++face) bytes += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("whole.ply", bytes)).triangles.size(), 2u);
    for (std::size_t length = 1; length < bytes.size(); length += 3)
        refused_file("cut.ply", bytes.substr(0, length));
    const std::string off = "OFF\n3 2 0\n" + std::string(three) + "3 0 1 2\n3 2 1 0\n";
    for (std::size_t length = 1; length + 3 < off.size(); length += 3)
        refused_file("cut.off", off.substr(0, length));
    const std::string stl =
        std::string(80, ' ') + std::string("\2\0\0\0", 4) + std::string(100, '\0');
    for (std::size_t length = 1; length < stl.size(); length += 7)
        refused_file("cut.stl", stl.substr(0, length));
}

TEST(BadMeshFile, OfFlippedBytesNeverCrashes) {
    Random random(7);
    std::string good = ply("3", "2", "", "binary_little_endian") + std::string(36, '\0');
    for (int face = 0; face < 2; ++face) good += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    const TemporaryFolder folder;
    int loaded = 0;
    for (int round = 0; round < 500; ++round) {
        std::string bytes = good;
        for (int k = 0; k < 1 + round % 4; ++k)
            bytes[random.next() % bytes.size()] = static_cast<char>(random.next());
        try {
            load_mesh(folder.write("flipped.ply", bytes));
            ++loaded;
        } catch (const InputError&) {
        }
    }
    EXPECT_GT(loaded, 0);
}

TEST(BadMeshFile, OfACadProgramIsToldWhatToExport) {
    for (const auto& [name, format] :
         {std::pair("a.step", "STEP"), std::pair("A.STP", "STEP"), std::pair("a.iges", "IGES"),
          std::pair("a.igs", "IGES"), std::pair("a.brep", "BREP"), std::pair("a.x_t", "Parasolid"),
          std::pair("a.sldprt", "SolidWorks"), std::pair("a.CATPart", "CATIA"),
          std::pair("a.ipt", "Inventor"), std::pair("a.FCStd", "FreeCAD"),
          std::pair("a.3dm", "Rhino"), std::pair("a.dwg", "DWG")})
        expect_in(std::string(format) +
                      " is a CAD format, which is not read; export a mesh as STL, PLY or OBJ",
                  refused_file(name, "ISO-10303-21;\n"));
}

TEST(BadMeshFile, ThatOnlyStartsLikeAPlyFileIsNone) {
    expect_in("the format is not known", refused_file("a.foo", "plywood\n1 2 3\n"));
}

// assimp would look for the files that it names in another folder.
TEST(BadMeshFile, WithABackslashInItsPathIsRefused) {
    expect_in("a backslash in the path of a mesh is not understood; rename it.",
              refused_file("a\\b.dae", dae_with("2")));
}

// assimp would read the named meshes with any of its readers, also with readers that are refused
// elsewhere.
TEST(BadMeshFile, OfASceneThatNamesMeshesIsNotRead) {
    const TemporaryFolder folder;
    folder.write("good.off", "OFF\n3 1 0\n" + std::string(three) + "3 0 1 2\n");
    const std::string lws = folder.write("a.lws", "LWSC\n3\n\nLoadObject good.off\n\n");
    expect_in("the format is not known", refusal([&] { load_mesh(lws); }));
}

}  // namespace
}  // namespace scb::scenes
