#include "scenes/meshes/off_check.h"

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

std::string refused_off(const std::string& text) {
    return refusal([&] { check_off(text, "a.off"); });
}

const std::string corners_of_square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(OffCheck, ChecksEveryCornerOfAPolygon) {
    check_off("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2 3\n", "a.off");
    expect_in("face 0 names vertex 4, but there are 4 vertices",
              refused_off("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2 4\n"));
    expect_in("face 0 of the 1 that are declared is missing or broken",
              refused_off("OFF\n4 1 0\n" + corners_of_square + "4 0 1 2\n"));
}

TEST(OffCheck, PassesOverCommentsAndTheDimensionOfTheSpace) {
    const std::string text = "nOFF # of space\n# three\n3\n\n4 1 0 # counts\n" + corners_of_square;
    check_off(text + "# faces\n4 0 1 2 3 # 9\n", "a.off");
    expect_in("face 0 names vertex 9", refused_off(text + "4 0 1 2 9\n"));
}

}  // namespace
}  // namespace scb::scenes
