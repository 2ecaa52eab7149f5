#include "scenes/meshes/obj_mesh.h"

#include <sys/stat.h>

#include "core/base/random.h"
#include "core/base/text_format.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

const std::string corners_of_four = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

Mesh obj_of(const std::string& text) {
    const TemporaryFolder folder;
    return load_mesh(folder.write("a.obj", text));
}

std::string refused_obj(const std::string& text) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.obj", text);
    const std::string sentence = refusal([&] { load_mesh(file); });
    EXPECT_EQ(sentence.rfind(file + ": ", 0), 0u) << text << sentence;
    return sentence;
}

TEST(ObjMesh, HasVerticesAndTrianglesInTheOrderOfTheFile) {
    const Mesh mesh = obj_of("# four\nmtllib a.mtl\no one\n" + corners_of_four +
                             "vt 0 0\nvn 0 0 1\ng x\nusemtl red\nf 1/1/1 2/1/1 3/1/1\ng y\nusemtl "
                             "blue\nf 1//1 2//1 4//1\ng x\nusemtl red\nf 2/1 3/1 4/1\nl 1 2\np 3\n"
                             "v 9 9 9\n");
    ASSERT_EQ(mesh.vertices.size(), 5u);
    EXPECT_EQ(mesh.vertices[3], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}}));
}

TEST(ObjMesh, CountsFromTheEndAndForwards) {
    const Mesh mesh =
        obj_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 -2 1\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {3, 2, 0}}));
}

TEST(ObjMesh, CutsPolygonsAndLeavesOutLines) {
    const Mesh mesh = obj_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\nf 1 2 3 4\nf\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjMesh, MayBeWrittenInManyWays) {
    const Mesh plain = obj_of(corners_of_four + "f 1 2 3\nf 1 2 4\n");
    for (const std::string& text : {
             std::string("v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 2 3\rf 1 2 4"),
             std::string("v 0 0 0\r\nv 1 0 0\r\n\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 2 3\r\nf 1 2 4\r\n"),
             std::string(
                 "\tv\t0 0\\\n 0 \\\r\n\nv 1. .0 0e5\nv +0 1E0 -0 1\n  v 0 0 1 .5 .5 .5 # 7 7\n"
                 "f 1 2\\\n 3#4\nf 1 2 4 # 3\n"),
             std::string(
                 "v 0 0 0\nv 1 0 0 1 1 1 1\nv 0 1 0\nv 0 0 1\nf 1/9/9 2/x 3/\nf 1// 2// 4//"),
             "\xEF\xBB\xBF" + corners_of_four + "f 1 2 3\nf 1 2 4\n",
             // Backslashes of names and comments are none.
             "# C:\\models\\\n" + corners_of_four +
                 "mtllib C:\\x\\\nf 1 2 3\ng a\\\nf 1 2 4 # \\\n",
         }) {
        const Mesh mesh = obj_of(text);
        EXPECT_EQ(mesh.vertices, plain.vertices) << text;
        EXPECT_EQ(mesh.triangles, plain.triangles) << text;
    }
}

TEST(ObjMesh, KeepsEveryNumberAndFace) {
    Random random(7);
    std::string text;
    Mesh made;
    for (int i = 0; i < 40000; ++i) {
        made.vertices.emplace_back(random.uniform(-1, 1), random.uniform(-1e-9, 1e9), i);
        const Vec3& v = made.vertices.back();
        text += "v " + exact_number(v.x()) + " " + exact_number(v.y()) + " " + exact_number(v.z()) +
                (i % 3 == 0 ? "\r\n" : "\n");
        if (i < 2) continue;
        const std::uint32_t a = random.below(static_cast<std::uint32_t>(i));
        made.triangles.push_back({a, static_cast<std::uint32_t>(i), 0});
        text += "f " + std::to_string(a + 1) + " -1 1\n";
    }
    const Mesh mesh = obj_of(text);  // of several windows of the file
    EXPECT_EQ(mesh.vertices, made.vertices);
    EXPECT_EQ(mesh.triangles, made.triangles);
}

TEST(ObjMesh, OfABrokenLineNamesIt) {
    expect_in("line 2: expected a coordinate, found \"1abc\"; repair it.",
              refused_obj("v 0 0 0\nv 1abc 0 0\nv 0 1 0\nf 1 2 3\n"));
    for (const char* word : {"0x10", "1d2", "1,5", "x", "--1"})
        expect_in(std::string("line 1: expected a coordinate, found \"") + word,
                  refused_obj(std::string("v ") + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    for (const char* numbers : {"", "1 2", "1 2 3 1 5", "1 2 3 4 5 6 7 8"})
        expect_in("a vertex has 3 coordinates",
                  refused_obj(std::string("v ") + numbers + "\nf 1 1 1\n"));
    expect_in("line 6: expected a corner such as 1, 1/2 or 1/2/3, found \"3x\"",
              refused_obj(corners_of_four + "f 1 2 3\nf 1 2 3x\n"));
    for (const char* corner : {"x", "1.5", "/1", "99999999999999999999"})
        expect_in("expected a corner", refused_obj(corners_of_four + "f 1 2 " + corner + "\n"));
    expect_in("line 5: names vertex 5, but there are 4 vertices, numbered from 1; repair",
              refused_obj(corners_of_four + "f 1 2 5\nf 1 2 3\n"));
    for (const char* corner : {"0", "-5", "300000000"})
        expect_in(std::string("line 5: names vertex ") + corner + " after 4 vertices",
                  refused_obj(corners_of_four + "f 1 2 " + corner + "\nf 1 2 3\n"));
    expect_in("the mesh has no triangles", refused_obj(corners_of_four + "l 1 2 3\nf 1 2\n"));
    expect_in("line 1 has more than 1 MiB", refused_obj(std::string(2 << 20, '\0')));
    std::string joined;
    for (int i = 0; i < 30; ++i) joined += (i == 0 ? "f" : "") + std::string(100'000, ' ') + "\\\n";
    expect_in("has more than 1 MiB", refused_obj(joined));
    expect_in("coordinate", refused_obj("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
}

TEST(ObjMesh, NamesLinesByTheirNumbersWhateverEndsThem) {
    for (const std::string end : {"\n", "\r\n", "\r"})
        expect_in("line 3: expected a coordinate, found \"x\"",
                  refused_obj("v 0 0 0" + end + end + "v 1 0 x" + end + "f 1 1 1" + end));
}

TEST(ObjMesh, PassesOverAWeightAlsoBeforeAColor) {
    for (const char* more : {"0.5", "0", "0.5 1 1 1"})
        EXPECT_EQ(obj_of(corners_of_four + "v 1 2 3 " + more + "\nf 1 2 5\n").vertices[4],
                  Vec3(1, 2, 3));
}

TEST(ObjMesh, KeepsALastLineThatEndsWithABackslash) {
    EXPECT_EQ(obj_of(corners_of_four + "f 1 2 3\nf 1 2 4 \\").triangles,
              (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}}));
}

// What a mesh looks like is not read from anywhere.
TEST(ObjMesh, OpensNoOtherFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const std::string text = "mtllib pipe\n" + corners_of_four + "usemtl red\nf 1 2 3\n";
    EXPECT_EQ(load_mesh(folder.write("mesh.obj", text)).triangles.size(), 1u);
}

}  // namespace
}  // namespace scb::scenes
