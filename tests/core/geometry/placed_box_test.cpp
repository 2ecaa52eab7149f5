#include "core/geometry/placed_box.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

TEST(PlacedBox, IsTheBoxOfTheMovedVerticesThatTrianglesUse) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {100, 100, 100}};
    mesh.triangles = {{0, 1, 2}};
    Pose pose;
    pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
    pose.translation = Vec3(10, 0, 0);
    const Box box = bounding_box(mesh, pose);
    EXPECT_EQ(box.lower, Vec3(9, 0, 0));
    EXPECT_EQ(box.upper, Vec3(10, 1, 1));
}

TEST(GapBetween, IsSignedAlongEachAxisAndNothingWhereBoxesOverlapOrTouch) {
    const Box unit{Vec3(0, 0, 0), Vec3(1, 1, 1)}, there{Vec3(3, -5, 1), Vec3(4, -2, 2)};
    EXPECT_EQ(gap_between(unit, there), Vec3(2, -2, 0));
    EXPECT_EQ(gap_between(there, unit), Vec3(-2, 2, 0));
    EXPECT_EQ(gap_between(unit, unit), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace scb
