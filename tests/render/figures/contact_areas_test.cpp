#include "render/figures/contact_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/common_area.h"
#include "render/figures/pairs_figure.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

/// Two squares of side 2 in one plane, B moved along x by 1, and all pairs of their triangles.
struct Squares {
    Mesh mesh = quad();
    TraceHeader header;
    QueryTrace frame;
    QueryBodies bodies;

    explicit Squares(const Vec3& by = Vec3(1, 0, 0)) {
        frame.b_to_a.translation = by;
        for (std::uint32_t a = 0; a < 2; ++a)
            for (std::uint32_t b = 0; b < 2; ++b) frame.found.pairs.push_back({a, b});
        for (QueryBody& body : bodies) body.mesh = &mesh;
        bodies[0].pose.translation = Vec3(0, 0, 5);
        bodies[1].pose.translation = Vec3(0, 0, 5) + by;
    }
};

TEST(ContactAreas, TogetherAreTheCommonPartOfBothFaces) {
    const Squares squares;
    double area = 0;
    for (const Area& part : contact_areas(squares.bodies, squares.frame)) {
        area += std::sqrt(squared_norm(area_normal(part.corners))) / 2;
        for (const Vec3& corner : part.corners) {
            EXPECT_GE(corner[0], 0);
            EXPECT_LE(corner[0], 1);
            EXPECT_GE(corner[2], 4);  // in the world
        }
    }
    EXPECT_DOUBLE_EQ(area, 2);
}

TEST(ContactAreas, HaveTheOutlineOfTheirUnion) {
    const Squares squares;
    const std::vector<Segment> lines =
        contact_segments(squares.bodies, squares.header, squares.frame);
    double length = 0;
    for (const Segment& line : lines) {
        const bool upright = line.from[0] == line.to[0] && (line.from[0] == 0 || line.from[0] == 1),
                   level = line.from[2] == line.to[2] && (line.from[2] == 4 || line.from[2] == 6);
        EXPECT_TRUE(upright || level);
        length += std::sqrt(squared_norm<double>(line.to - line.from));
    }
    EXPECT_DOUBLE_EQ(length, 6);
}

TEST(ContactAreas, AreNoneWhereFacesTouchAtAnEdge) {
    const Squares squares(Vec3(2, 0, 0));
    EXPECT_TRUE(contact_areas(squares.bodies, squares.frame).empty());
}

TEST(ContactAreas, LeaveTheLinesOfTrianglesThatCross) {
    // Both triangles of A lie on a triangle of B, and B stands on A at its other one.
    Squares squares(Vec3::Zero());
    Mesh bent = quad();
    bent.vertices[3] = Vec3(0.5, 1, 0);
    bent.vertices.push_back(Vec3(0.5, -1, 0.5));
    bent.triangles = {{0, 1, 2}, {0, 3, 4}};
    squares.bodies[1].mesh = &bent;
    Mesh both = quad();
    both.vertices.push_back(bent.vertices[3]);
    both.vertices.push_back(bent.vertices[4]);
    both.triangles.push_back({0, 4, 5});
    squares.bodies[0].mesh = &both;
    // (0, 0) and (2, 1) are areas; (0, 1) crosses.
    squares.frame.found.pairs = {{0, 0}, {0, 1}, {2, 1}};
    const std::vector<Segment> lines =
        contact_segments(squares.bodies, squares.header, squares.frame);
    EXPECT_EQ(contact_areas(squares.bodies, squares.frame).size(), 2u);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const Segment& s) { return s.id == 1; }),
              1);
}

TEST(ContactAreas, ThatAreTheSameHaveOneOutline) {
    const std::vector<Vec3> square = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)},
                            turned(square.rbegin(), square.rend());
    for (const std::vector<Vec3>& other : {square, turned}) {
        const std::vector<Segment> lines =
            outlines_of({{square, {}, 0}, {other, {}, 1}, {square, {}, 2}});
        ASSERT_EQ(lines.size(), 4u);
        for (const Segment& line : lines) EXPECT_EQ(line.id, 0u);
    }
}

TEST(ContactAreas, AnEdgeBetweenTwoPlanesIsAnOutlineOfBoth) {
    // Two sides of a box.
    const std::vector<Area> areas = {
        {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {}, 0},
        {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0, 0, 1)}, {}, 1}};
    EXPECT_EQ(outlines_of(areas).size(), 8u);
}

}  // namespace
}  // namespace scb::render
