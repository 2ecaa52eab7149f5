#include "scenes/meshes/off_mesh.h"

#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

Mesh off_of(const std::string& text) {
    const TemporaryFolder folder;
    return off_mesh(folder.write("a.off", text));
}

std::string refused_off(const std::string& text) {
    return refusal([&] { off_of(text); });
}

const std::string corners_of_square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::vector<Triangle> two_of_square = {{0, 1, 2}, {0, 2, 3}};

TEST(OffMesh, ChecksEveryCornerOfAPolygon) {
    EXPECT_EQ(off_of("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2 3\n").triangles, two_of_square);
    expect_in("face 0 names vertex 4, but there are 4 vertices",
              refused_off("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2 4\n"));
    expect_in("face 0 of the 1 that are declared is missing or broken",
              refused_off("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2\n"));
}

TEST(OffMesh, PassesOverCommentsAndTheDimensionOfTheSpace) {
    const std::string text = "nOFF # of space\n# three\n3\n\n4 1 0 # counts\n" + corners_of_square;
    EXPECT_EQ(off_of(text + "# faces\n4 0 1 2 3 # 9\n").triangles, two_of_square);
    expect_in("face 0 names vertex 9", refused_off(text + "4 0 1 2 9\n"));
}

TEST(OffMesh, GoesOnInTheNextLine) {
    const std::string vertices = "0 0\n0\n1\n0 0\n1 1 0\n0 1 0\n";
    for (const char* header : {"OFF\n4 2 0\n", "OFF\n4\n2\n0\n", "OFF 4\n2 # two\n0\n",
                               "OFF\r\n4 2\r\n", "4 2\n", "OFF\r4 2 0\r"}) {
        const Mesh mesh = off_of(header + vertices + "3 0\n1\n2\n3\n0 2 3");
        EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}))
            << header;
        EXPECT_EQ(mesh.triangles, two_of_square) << header;
    }
}

TEST(OffMesh, PassesOverWhatFollowsOnALine) {
    EXPECT_EQ(off_of("OFF\n4 2 5\n0 0 0 255 0 0\n1 0 0 9\n1 1 0\n0 1 0 1 1 1 1\n3 0 1 2 0.5 0 0\n"
                     "3 0 2 3 7\n")
                  .triangles,
              two_of_square);
    const std::string seven = " 1 2 3 4 5 6 7\n";
    EXPECT_EQ(off_of("CNOFF\n3 1 0\n0 0 0" + seven + "1 0 0" + seven + "0 1 0" + seven + "3 0 1 2")
                  .vertices,
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    // Two or more vertices on a line.
    expect_in("the line of vertex 0 has 6 words after the coordinates, but a color has 1, 3 or 4",
              refused_off("OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n"));
}

TEST(OffMesh, DividesByTheFourthNumber) {
    EXPECT_EQ(off_of("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 4 0 4\n3 0 1 2\n").vertices,
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(off_of("nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n").vertices,
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    expect_in("its space has the dimension 5", refused_off("nOFF 5\n3 1 0\n"));
}

TEST(OffMesh, HasDoublesAndKeepsDegenerateTriangles) {
    const Mesh mesh = off_of("OFF\n3 2 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 1\n2 0 1\n");
    EXPECT_EQ(mesh.vertices[0][0], 0.1);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 1}}));
}

TEST(OffMesh, ThatIsBinaryIsRefusedByName) {
    expect_in("binary OFF is not read; export a text OFF, PLY or STL.",
              refused_off("OFF BINARY\n" + std::string(40, '\0')));
    expect_in("binary OFF is not read", refused_off("COFF BINARY\n" + std::string(40, '\1')));
}

TEST(OffMesh, IsKnownByItsFirstWord) {
    for (const char* word : {"OFF", "COFF", "NOFF", "STCN4nOFF", "# a comment\n  OFF"})
        EXPECT_TRUE(is_off(word + std::string("\n3 1 0\n"))) << word;
    for (const char* word : {"OFFICE", "solid OFF", "off", "3 1 0", "xOFF", ""})
        EXPECT_FALSE(is_off(word)) << word;
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("a.mesh", "OFF\n4 1 0\n" + corners_of_square + "4 0 1 2 3\n"))
                  .triangles,
              two_of_square);
}

}  // namespace
}  // namespace scb::scenes
