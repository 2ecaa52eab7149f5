#include "scenes/meshes/ply_mesh.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/base/random.h"
#include "core/base/text_format.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

/// Writes numbers as a PLY file holds them.
struct PlyWriter {
    std::string format;  ///< of the header
    std::string bytes;

    void number(const std::string& type, double value) {
        if (format == "ascii") {
            bytes += exact_number(value) + " ";
            return;
        }
        if (type == "float") return raw_bits(std::bit_cast<std::uint32_t>(float(value)), 4);
        if (type == "double") return raw_bits(std::bit_cast<std::uint64_t>(value), 8);
        const std::size_t size = type.ends_with("char") ? 1 : type.ends_with("short") ? 2 : 4;
        raw_bits(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), size);
    }
    void end_of_row(const std::string& end) {
        if (format == "ascii") bytes += end;
    }

  private:
    void raw_bits(std::uint64_t bits, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t place = format == "binary_big_endian" ? size - 1 - i : i;
            bytes += static_cast<char>(bits >> (8 * place) & 255);
        }
    }
};

template <std::size_t n>
std::string one_of(Random& random, const std::array<const char*, n>& words) {
    return words[random.next() % n];
}

/// A random valid file of the format, and the mesh in it.
struct AnyPly {
    std::string bytes;
    Mesh mesh;

    explicit AnyPly(std::uint64_t seed) {
        Random random(seed);
        PlyWriter writer{
            one_of(random, std::array{"ascii", "binary_little_endian", "binary_big_endian"}), ""};
        const std::string end = one_of(random, std::array{"\n", "\r\n", "\r"});
        const auto number_type = [&] {
            return one_of(random, std::array{"char", "uchar", "short", "ushort", "int", "uint",
                                             "float", "double"});
        };
        const auto coin = [&] { return random.next() % 2 == 0; };
        const std::array<std::string, 3> axis_types = {number_type(), number_type(), number_type()};
        const std::string length_type = one_of(random, std::array{"uchar", "ushort", "int"}),
                          index_type = one_of(random, std::array{"int", "uint", "float", "double"}),
                          list = one_of(random, std::array{"vertex_indices", "vertex_index",
                                                           "vertex_indexes", "vert_indices"}),
                          other_type = number_type(), other_list = number_type();
        const bool other_first = coin(), faces_first = coin(), has_unknown = coin();
        const std::size_t vertices = 3 + random.next() % (seed % 8 == 0 ? 70'000 : 50),
                          faces = 1 + random.next() % (2 * vertices);

        std::string vertex_header = "element vertex " + std::to_string(vertices) + end;
        if (other_first) vertex_header += "property " + other_type + " quality" + end;
        for (int axis = 0; axis < 3; ++axis)
            vertex_header +=
                "property " + axis_types[static_cast<std::size_t>(axis)] + " " + "xyz"[axis] + end;
        vertex_header += "property list uchar " + other_list + " x" + end;
        const std::string face_header =
            "element face " + std::to_string(faces) + end +
            (other_first ? "property list uchar float texcoord" + end : "") + "property list " +
            length_type + " " + index_type + " " + list + end + "property uchar red" + end;
        const std::string unknown_header =
            "element edge 7" + end + "property int a" + end + "property list int double b" + end;

        const auto any_list = [&](const std::string& type) {
            const std::size_t count = random.next() % 4;
            writer.number("uchar", static_cast<double>(count));
            for (std::size_t i = 0; i < count; ++i) writer.number(type, 1);
        };
        const auto write_vertices = [&] {
            for (std::size_t i = 0; i < vertices; ++i) {
                if (other_first) writer.number(other_type, 1);
                Vec3 v;
                for (int axis = 0; axis < 3; ++axis) {
                    const std::string& type = axis_types[static_cast<std::size_t>(axis)];
                    v[axis] = static_cast<double>(random.next() % 100);
                    if (type == "float" || type == "double")
                        v[axis] = (random.uniform() - 0.5) * 1e6;
                    if (type == "float") v[axis] = static_cast<double>(float(v[axis]));
                    writer.number(type, v[axis]);
                }
                mesh.vertices.push_back(v);
                any_list(other_list);
                writer.end_of_row(end);
            }
        };
        const auto write_faces = [&] {
            for (std::size_t i = 0; i < faces; ++i) {
                if (other_first) any_list("float");
                const std::size_t corners = random.next() % 8 == 0 ? random.next() % 3 : 3;
                writer.number(length_type, static_cast<double>(corners));
                Triangle t{};
                for (std::size_t k = 0; k < corners; ++k) {
                    t[k] = static_cast<std::uint32_t>(random.next() % vertices);
                    writer.number(index_type, static_cast<double>(t[k]));
                }
                if (corners == 3) mesh.triangles.push_back(t);
                writer.number("uchar", 200);
                writer.end_of_row(end);
            }
        };
        if (has_unknown) {
            for (int i = 0; i < 7; ++i) {
                writer.number("int", -i);
                writer.number("int", i);
                for (int k = 0; k < i; ++k) writer.number("double", 0.5);
                writer.end_of_row(end);
            }
        }
        if (faces_first) write_faces();
        write_vertices();
        if (!faces_first) write_faces();
        bytes = "ply" + end + "format " + writer.format + " 1.0" + end + "comment made by a test" +
                end + (has_unknown ? unknown_header : "") +
                (faces_first ? face_header + vertex_header : vertex_header + face_header) +
                "end_header" + end + writer.bytes;
    }
};

TEST(PlyMesh, IsReadFromAllThatTheFormatAllows) {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const AnyPly any(seed);
        const Mesh mesh = ply_mesh(folder.write("a.ply", any.bytes));
        EXPECT_EQ(mesh.vertices, any.mesh.vertices) << seed;
        EXPECT_EQ(mesh.triangles, any.mesh.triangles) << seed;
    }
}

std::string square(const std::string& rest, const std::string& header) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
           "property double z\n" +
           header + "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n" + rest;
}
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";

Mesh read(const std::string& bytes) {
    const TemporaryFolder folder;
    return ply_mesh(folder.write("a.ply", bytes));
}
std::string refused(const std::string& bytes) {
    return refusal([&] { read(bytes); });
}

TEST(PlyMesh, HasThePrecisionThatTheHeaderDeclares) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty float y\n"
        "property double z\n" +
        faces + "end_header\n0.1 0.1 1e-400\n+1.5 1e39 -1e999\n-.5e1 1e-60 0\n3 0 1 2\n";
    const Mesh mesh = read(text);
    EXPECT_EQ(mesh.vertices[0], Vec3(0.1, static_cast<double>(0.1f), 0));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(mesh.vertices[1], Vec3(1.5, infinity, -infinity));
    EXPECT_EQ(mesh.vertices[2], Vec3(-5, 0, 0));
}

TEST(PlyMesh, HasTheTrianglesOfStrips) {
    const auto triangles = [](const std::string& strip) {
        return read(square(strip, "element tristrips 1\nproperty list int int vertex_indices\n"))
            .triangles;
    };
    using Triangles = std::vector<Triangle>;
    EXPECT_EQ(triangles("4 0 1 2 3\n"), (Triangles{{0, 1, 2}, {2, 1, 3}}));
    // A new strip starts with its own orientation, and those too short for a triangle have none.
    EXPECT_EQ(triangles("9 0 1 2 3 -1 3 2 1 0\n"),
              (Triangles{{0, 1, 2}, {2, 1, 3}, {3, 2, 1}, {1, 2, 0}}));
    EXPECT_EQ(triangles("8 -1 0 1 -1 -1 1 3 2\n"), (Triangles{{1, 3, 2}}));
    // Strips may be joined by triangles that name a vertex twice.
    EXPECT_EQ(triangles("8 0 1 2 2 3 3 2 1\n"), (Triangles{{0, 1, 2}, {2, 3, 1}}));
    EXPECT_EQ(triangles("5 0 1 2 1 3\n"), (Triangles{{0, 1, 2}, {2, 1, 3}}));
    const std::string refusal_of_five = refused(
        square("5 0 1 2 -2 3\n", "element tristrips 1\nproperty list int int vertex_indices\n"));
    expect_in("tristrips 0 names vertex -2", refusal_of_five);
    const Mesh both =
        read(square("3 0 1 2\n3 1 2 3\n",
                    faces + "element tristrips 1\nproperty list int int vertex_indices\n"));
    EXPECT_EQ(both.triangles, (Triangles{{0, 1, 2}, {1, 2, 3}}));
}

/// Three vertices whose x is the number, of this type, in this encoding.
double read_back(const std::string& format, const std::string& type, const std::string& alias,
                 double number) {
    PlyWriter writer{format, ""};
    for (int i = 0; i < 3; ++i) {
        writer.number(type, number);
        writer.number("float", 0);
        writer.number("float", 0);
    }
    writer.number("uchar", 3);
    for (int i = 0; i < 3; ++i) writer.number("int", i);
    const Mesh mesh =
        read("ply\nformat " + format + " 1.0\nelement vertex 3\nproperty " + alias +
             " x\nproperty float y\nproperty float z\n" + faces + "end_header\n" + writer.bytes);
    return mesh.vertices[0][0];
}

TEST(PlyMesh, HasTheLeastAndTheGreatestNumberOfEachType) {
    struct Row {
        const char *type, *alias;
        double least, greatest;
    };
    for (const Row& row : {Row{"char", "int8", -128, 127},
                           {"uchar", "uint8", 0, 255},
                           {"short", "int16", -32768, 32767},
                           {"ushort", "uint16", 0, 65535},
                           {"int", "int32", -2147483648, 2147483647},
                           {"uint", "uint32", 0, 4294967295},
                           {"float", "float32", -1.5, 0.25},
                           {"double", "float64", -1e300, 0.1}})
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
            for (const double number : {row.least, row.greatest})
                for (const char* name : {row.type, row.alias})
                    EXPECT_EQ(read_back(format, row.type, name, number), number)
                        << format << ", " << name;
}

TEST(PlyMesh, CutsFacesOfMoreThanThreeCorners) {
    EXPECT_EQ(read(square("4 0 1 3 2\n", faces)).triangles,
              (std::vector<Triangle>{{0, 1, 3}, {0, 3, 2}}));
}

TEST(PlyMesh, IsRefusedWhereAnythingThatCountsStandsTwice) {
    expect_in("declares element face twice", refused(square("3 0 1 2\n3 0 1 2\n", faces + faces)));
    expect_in("declares element vertex twice",
              refused(square("",
                             "element vertex 1\nproperty float x\nproperty float y\n"
                             "property float z\n" +
                                 faces)));
    expect_in("face element has two lists of vertices",
              refused(square("", faces + "property list uchar int vert_indices\n")));
    expect_in("vertex element has the property x twice",
              refused(square("", "property float x\n" + faces)));
    expect_in("header line 3: there is a second format line",
              refused("ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n"));
}

TEST(PlyMesh, IsRefusedWithoutWhatItNeeds) {
    expect_in("the header has no format line", refused("ply\nend_header\n"));
    expect_in("face element has no list vertex_indices",
              refused(square("3 0 1 2\n", "element face 1\nproperty list uchar int corners\n")));
    expect_in("face element has no list vertex_indices",
              refused(square("0\n", "element face 1\nproperty int vertex_indices\n")));
    expect_in("needs a whole-number type",
              refused(square("", "element face 1\nproperty list float int vertex_indices\n")));
    expect_in("header line 7: element face needs a count, a whole number from 0",
              refused(square("3 0 1 2\n", "element face 1.5\n")));
    expect_in("face 0 has a list with a length that is not a whole number",
              refused(square("2.5 0 1\n", faces)));
    expect_in("face 0 names vertex 4, but there are 4 vertices",
              refused(square("3 0 1 4\n", faces)));
    expect_in("face 0 names vertex 0.5", refused(square("3 0 1 0.5\n", faces)));
    expect_in("face 0 names vertex nan", refused(square("3 0 1 nan\n", faces)));
    expect_in("face 0 of the 1 that the header declares is missing or is not made of numbers",
              refused(square("3 0 1 " + std::string(5000, '1'), faces)));
    expect_in("face 0 of the 1 that the header declares is missing",
              refused(square("3 0 1", faces)));
}

TEST(PlyMesh, IsRefusedFromAHeaderThatIsTooLong) {
    const std::string start = "ply\nformat ascii 1.0\ncomment ";
    expect_in("header line 3: it is longer than 65536 bytes",
              refused(start + std::string(70'000, 'x')));
    std::string lines = start;
    for (int i = 0; i < 10'000; ++i) lines += "x\n";
    expect_in("header line 10001: no header has so many lines", refused(lines));
    EXPECT_EQ(read(square("3 0 1 2\n", "comment " + std::string(60'000, 'x') + "\n" + faces))
                  .triangles.size(),
              1u);
}

TEST(PlyMesh, OfMoreThanCanBeIsRefusedFromItsHeader) {
    for (const char* element : {"edge", "vertex", "face", "tristrips"}) {
        const std::string sentence =
            refused("ply\nformat ascii 1.0\nelement " + std::string(element) +
                    " 268435457\nproperty float x\nend_header\n");
        expect_in("the header declares 268435457 elements of the kind", sentence);
    }
    // A list that says that it is long takes no memory.
    expect_in("its faces have more than 268435456 corners",
              refused(square("4000000000 0 1 2\n",
                             "element face 1\nproperty list uint int "
                             "vertex_indices\n")));
    // The limit holds for all faces together.
    expect_in("its faces have more than 268435456 corners",
              refused(square("3 0 1 2\n268435456 0 1 2\n",
                             "element face 2\nproperty list uint int "
                             "vertex_indices\n")));
    expect_in("face 0 of the 1", refused(square("200000000 0 1 2\n",
                                                "element face 1\nproperty list uint int "
                                                "vertex_indices\n")));
}

}  // namespace
}  // namespace scb::scenes
