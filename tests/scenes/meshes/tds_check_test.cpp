#include "scenes/meshes/tds_check.h"

#include <array>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

std::string tds_number(std::size_t value) {
    return {static_cast<char>(value & 255), static_cast<char>(value >> 8)};
}

std::string tds_chunk(std::size_t id, const std::string& inside) {
    return tds_number(id) + tds_number(inside.size() + 6) + tds_number(0) + inside;
}

/// An object of this many vertices, and a list of faces that have visible edges.
std::string tds_object(std::size_t vertices, const std::vector<std::array<std::size_t, 3>>& of) {
    std::string list = tds_number(of.size());
    for (const auto& [a, b, c] : of)
        list += tds_number(a) + tds_number(b) + tds_number(c) + tds_number(7);
    const std::string corners = tds_number(vertices) + std::string(12 * vertices, '\0');
    return tds_chunk(0x4000,
                     std::string("m\0", 2) +
                         tds_chunk(0x4100, tds_chunk(0x4110, corners) + tds_chunk(0x4120, list)));
}

void check_objects(const std::string& objects) {
    check_3ds(tds_chunk(0x4d4d, tds_chunk(0x3d3d, objects)), "a.3ds");
}

TEST(TdsCheck, NamesTheFaceAndTheCornerThatAreWrong) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        std::vector<std::array<std::size_t, 3>> three_faces = {{0, 1, 2}, {2, 1, 0}, {0, 2, 1}};
        check_objects(tds_object(3, three_faces));
        three_faces[2][corner] = 3;
        EXPECT_EQ(refusal([&] { check_objects(tds_object(3, three_faces)); }),
                  "a.3ds: mesh 0, face 2 names vertex 3, but there are 3 vertices, numbered from "
                  "0; repair the index.");
    }
}

TEST(TdsCheck, OfSeveralMeshesEachHasItsOwnVertices) {
    const std::string of_four = tds_object(4, {{0, 1, 3}}), of_three = tds_object(3, {{0, 1, 2}});
    check_objects(of_four + of_three);
    check_objects(of_three + of_four);
    expect_in("mesh 1, face 0 names vertex 3, but there are 3 vertices", refusal([&] {
                  check_objects(of_four + tds_object(3, {{0, 1, 3}}));
              }));
}

}  // namespace
}  // namespace scb::scenes
