#include "core/analysis/waste_causes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/hierarchy.h"

namespace scb {
namespace {

/// Strips of so many triangles, each so many times as long as it is high.
Mesh strips(std::uint32_t count, double length, double size = 1) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double y = 2 * i;
        for (const Vec3& v : {Vec3(0, y, 0), Vec3(length, y, 0), Vec3(0, y + 1, 0)})
            mesh.vertices.push_back(size * v);
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

/// A square grid of triangles that are all connected.
Mesh grid(std::uint32_t side) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x) mesh.vertices.push_back(Vec3(x, y, 0));
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t i = y * (side + 1) + x;
            mesh.triangles.push_back({i, i + 1, i + side + 1});
            mesh.triangles.push_back({i + 1, i + side + 2, i + side + 1});
        }
    return mesh;
}

Mat3 about_x(double degrees) {
    return Eigen::AngleAxisd(degrees * 3.14159265358979 / 180, Vec3::UnitX()).toRotationMatrix();
}

WasteCauses causes_of(const Mesh& a, const Mesh& b, const VainTests& vain = {}) {
    return waste_causes({a, depth(tree_shape(build_topology(a)))},
                        {b, depth(tree_shape(build_topology(b)))}, vain);
}

TEST(WasteCauses, NameWhatIsWrongWithAMeshAndNothingElse) {
    Mesh twice = grid(10);
    twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(),
                           twice.triangles.begin() + 4);
    const WasteCauses causes = causes_of(strips(40, 50), twice);
    const auto& [a, b] = causes.bodies;
    EXPECT_TRUE(a.slender && a.soup);
    EXPECT_FALSE(a.duplicated || a.deep);
    EXPECT_TRUE(b.duplicated);
    EXPECT_FALSE(b.slender || b.soup || b.deep);
    EXPECT_FALSE(causes.unequal || causes.parallel);
}

TEST(WasteCauses, AShareOfTheTrianglesIsEnough) {
    // One of 20 triangles is slender, then one of 21.
    for (const std::uint32_t others : {19u, 20u}) {
        Mesh mesh = strips(others, 2);
        for (const Vec3& v : {Vec3(0, -9, 0), Vec3(50, -9, 0), Vec3(0, -8, 0)}) {
            mesh.vertices.push_back(v);
        }
        mesh.triangles.push_back({3 * others, 3 * others + 1, 3 * others + 2});
        EXPECT_EQ(causes_of(mesh, grid(3)).bodies[0].slender, others == 19);
    }
    // One of 100 triangles is there twice, then one of 101.
    for (const std::uint32_t count : {99u, 100u}) {
        Mesh mesh = strips(count, 2);
        mesh.triangles.push_back(mesh.triangles[0]);
        EXPECT_EQ(causes_of(mesh, grid(3)).bodies[0].duplicated, count == 99);
    }
    EXPECT_FALSE(causes_of(strips(1, 2), grid(3)).bodies[0].soup) << "one triangle is one part";
    EXPECT_TRUE(causes_of(strips(2, 2), grid(3)).bodies[0].soup);
}

TEST(WasteCauses, CountTestsOfSlenderTrianglesAndOfCopies) {
    // Triangles 0 to 9 are slender, 10 to 19 are not, and 20 and 21 are copies of 3 and 12.
    Mesh mesh = strips(20, 50);
    for (std::uint32_t i = 10; i < 20; ++i) mesh.vertices[3 * i + 1][0] = 2;
    mesh.triangles.push_back(mesh.triangles[3]);
    mesh.triangles.push_back(mesh.triangles[12]);
    EXPECT_EQ(duplicate_triangles(mesh), (std::vector<std::uint32_t>{20, 21}));
    const Mesh other = grid(3);
    const auto tests_of = [&](std::vector<TestedTriangle> tested) {
        const BodyCauses a = waste_causes({mesh, 5, std::move(tested)}, {other, 5}, {}).bodies[0];
        return std::pair(a.slender_tests, a.duplicate_tests);
    };
    using Tests = std::pair<std::uint64_t, std::uint64_t>;
    EXPECT_EQ(tests_of({}), Tests(0, 0));
    EXPECT_EQ(tests_of({{3, 100, 1}, {12, 10, 1}}), Tests(100, 0)) << "no copy of an earlier one";
    EXPECT_EQ(tests_of({{3, 100, 1}, {20, 7, 1}, {21, 1, 1}}), Tests(107, 8));
}

TEST(WasteCauses, ATreeThatTakesOffATenthAtATimeIsDeep) {
    // Clusters: each has about a tenth of the remaining triangles. Its position is a third of the
    // previous cluster's position.
    Mesh mesh;
    std::uint32_t left = 2000;
    for (double x = 1; left > 0; x /= 3) {
        const std::uint32_t count = left / 9 + 1;
        for (std::uint32_t i = 0; i < count && left > 0; ++i, --left) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const double y = x * 1e-3 * i / count;
            mesh.vertices.insert(mesh.vertices.end(),
                                 {{x, y, 0}, {x, y + x * 1e-3, 0}, {x, y, x * 1e-3}});
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
    }
    const WasteCauses causes = causes_of(mesh, grid(30));
    EXPECT_TRUE(causes.bodies[0].deep) << causes.bodies[0].depth;
    EXPECT_FALSE(causes.bodies[1].deep) << causes.bodies[1].depth;
}

TEST(WasteCauses, SayWhichBodyIsLargerAndWhereSurfacesAreParallel) {
    const WasteCauses causes = causes_of(strips(4, 2, 100), strips(4, 2), {10, 5});
    EXPECT_TRUE(causes.unequal);
    EXPECT_NEAR(causes.larger, 100, 1e-9);
    EXPECT_TRUE(causes.parallel);
    EXPECT_TRUE(causes_of(strips(4, 2), strips(4, 2, 100)).unequal);
    EXPECT_FALSE(causes_of(strips(4, 2), strips(4, 2), {10, 4}).parallel);
}

TEST(VainTests, CountPairsThatAreNearlyParallelInTheirPose) {
    const Mesh mesh = grid(1);
    QueryTrace frame;
    frame.b_to_a.rotation = about_x(9);
    frame.steps.items = {{{0, 0}, 0, false}, {{0, 1}, 0, false}, {{1, 1}, 0, true}};
    const VainTests near = vain_tests(mesh, mesh, frame);
    EXPECT_EQ(near.tests, 2u);
    EXPECT_EQ(near.parallel, 2u);
    // The same at any size: powers of lengths must not overflow or vanish.
    for (const double scale : {1e-60, 1e60}) {
        Mesh scaled = mesh;
        for (Vec3& v : scaled.vertices) v *= scale;
        frame.b_to_a.rotation = about_x(9);
        EXPECT_EQ(vain_tests(scaled, scaled, frame).parallel, 2u) << scale;
        frame.b_to_a.rotation = about_x(11);
        EXPECT_EQ(vain_tests(scaled, scaled, frame).parallel, 0u) << scale;
    }
    frame.b_to_a.rotation = about_x(11);
    EXPECT_EQ(vain_tests(mesh, mesh, frame).parallel, 0u);
}

}  // namespace
}  // namespace scb
