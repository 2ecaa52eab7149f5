#include "scenes/scene/builtin.h"

#include <set>

#include "scenes/shapes/torus_knot.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TEST(BuiltinScenes, AreListedInAFixedOrder) {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
    EXPECT_EQ(names, (std::vector<std::string>{"spheres-l1",
                                               "spheres-l2",
                                               "knots-l1",
                                               "knots-l2",
                                               "knots-l3",
                                               "horses",
                                               "hands",
                                               "dragons",
                                               "aatbase",
                                               "tray_bottom",
                                               "boeing",
                                               "cheese",
                                               "tr12j",
                                               "anchor",
                                               "cycloidal",
                                               "tube",
                                               "aatbase-aligned",
                                               "tray_bottom-aligned",
                                               "plate_holes-aligned",
                                               "anchor-aligned",
                                               "boeing-aligned",
                                               "cheese-aligned",
                                               "tube-aligned",
                                               "stack",
                                               "shaft-in-bore",
                                               "box-grid",
                                               "mesh-on-itself",
                                               "flat-plate",
                                               "concentric-spheres",
                                               "thin-cylinder",
                                               "cone",
                                               "soup",
                                               "line-8",
                                               "lines-20-23",
                                               "long-triangles"}));
    EXPECT_EQ(find_builtin("nothing"), nullptr);
}

TEST(BuiltinScenes, WithoutMeshFilesLoadAndMoveRigidlyInEveryFrame) {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        if (!builtin.mesh_files.empty()) continue;  // see builtin_meshes_test.cpp
        const Scene scene = load_builtin(builtin);
        EXPECT_EQ(scene.name, builtin.name);
        EXPECT_EQ(scene.description, builtin.description);
        EXPECT_EQ(scene.frames, builtin.frames);
        EXPECT_EQ(builtin.description.back(), '.');
        EXPECT_TRUE(scene.camera);
        EXPECT_EQ(scene.bodies.size(), 2u);
        for (const NamedMesh& mesh : scene.meshes) check_mesh(mesh.mesh, mesh.name);
        for (const Body& body : scene.bodies)
            for (int frame = 0; frame < scene.frames; ++frame)
                EXPECT_LT(rigidity_defect(pose_at(body.motion, frame)), 1e-14);
    }
}

TEST(BuiltinScenes, HaveTheTriangleCountsOfTable2) {
    const auto counts = [](const char* name) {
        std::vector<std::size_t> result;
        for (const NamedMesh& mesh : load_builtin(*find_builtin(name)).meshes)
            result.push_back(mesh.mesh.triangles.size());
        return result;
    };
    EXPECT_EQ(counts("spheres-l1"), (std::vector<std::size_t>{20480, 20480}));
    EXPECT_EQ(counts("spheres-l2"), (std::vector<std::size_t>{81920, 81920}));
    EXPECT_EQ(counts("knots-l1"), (std::vector<std::size_t>{3528, 3672}));
    EXPECT_EQ(counts("knots-l2"), (std::vector<std::size_t>{6860, 7140}));
    EXPECT_EQ(counts("knots-l3"), (std::vector<std::size_t>{10976, 11424}));
}

TEST(BuiltinScenes, AreToldApartByTheirDescriptions) {
    std::set<std::string> descriptions;
    for (const BuiltinScene& scene : builtin_scenes()) descriptions.insert(scene.description);
    EXPECT_EQ(descriptions.size(), builtin_scenes().size());
    expect_in("20,480 triangles each", find_builtin("spheres-l1")->description);
    expect_in("10,976 and 11,424 triangles", find_builtin("knots-l3")->description);
}

TEST(BuiltinScenes, StartTheSpheresWithTheGapInTheInset) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
    EXPECT_EQ(scene.frames, 500);
    const Pose a = pose_at(scene.bodies[0].motion, 0), b = pose_at(scene.bodies[1].motion, 0);
    double right_of_a = -10, left_of_b = 10;
    for (const Vec3& v : scene.meshes[0].mesh.vertices)
        right_of_a = std::max(right_of_a, transform_point(a, v)[0]);
    for (const Vec3& v : scene.meshes[1].mesh.vertices)
        left_of_b = std::min(left_of_b, transform_point(b, v)[0]);
    EXPECT_NEAR(right_of_a, -0.05, 1e-3);
    EXPECT_NEAR(left_of_b, 0, 1e-3);
    const Inset inset = scene.camera->inset.value();
    EXPECT_LT(inset.center[0] - inset.radius, right_of_a);
    EXPECT_GT(inset.center[0] + inset.radius, left_of_b);
}

TEST(BuiltinScenes, KeepTheKnotsStillToEachOtherButNotAtTheIdentity) {
    const Scene scene = load_builtin(*find_builtin("knots-l1"));
    const Mat3 stored = rotation_about(Vec3(1, -2, 0.5), 40);
    for (const int frame : {0, 100, 499}) {
        const Pose relative = relative_pose(pose_at(scene.bodies[0].motion, frame),
                                            pose_at(scene.bodies[1].motion, frame));
        EXPECT_LT((relative.rotation - stored).cwiseAbs().maxCoeff(), 1e-15);
    }
    // Seen in A's frame, B is the companion tube as it was made.
    TorusKnot companion;
    companion.rings = 153;
    companion.offset = 0.9;
    const Mesh tube = torus_knot_mesh(companion);
    const Pose relative =
        relative_pose(pose_at(scene.bodies[0].motion, 77), pose_at(scene.bodies[1].motion, 77));
    for (std::size_t i = 0; i < tube.vertices.size(); ++i)
        EXPECT_LT(
            (transform_point(relative, scene.meshes[1].mesh.vertices[i]) - tube.vertices[i]).norm(),
            1e-13);
}

}  // namespace
}  // namespace scb::scenes
