#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "scenes/scene/builtin.h"
#include "scenes/scene/load_scene.h"
#include "scenes/scene/scene_file.h"
#include "scenes/scene/scene_group.h"
#include "tests/real_models.h"
#include "tests/scenes/support.h"

// The built-in scenes whose meshes are files of others.

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

struct SceneWithMesh {
    const char *name, *file;
    std::size_t vertices, triangles;
};

constexpr SceneWithMesh scenes_with_meshes[] = {
    {"horses", "horse.ply", 48485, 96966},
    {"hands", "skeleton_hand.ply", 57065, 114037},
    {"dragons", "dragon.ply", 437645, 871414},
    {"aatbase", "aatbase.ply", 1820, 3660},
    {"tray_bottom", "tray_bottom.ply", 2216, 4520},
    {"boeing", "boeing.ply", 2741, 2564},
    {"cheese", "cheese.ply", 8629, 17786},
    {"tr12j", "tr12j.ply", 13441, 26966},
    {"anchor", "anchor.ply", 519, 1050},
    {"cycloidal", "cycloidal.ply", 21384, 43368},
    {"tube", "tube.ply", 560, 1120},
    {"aatbase-aligned", "aatbase.ply", 1820, 3660},
    {"tray_bottom-aligned", "tray_bottom.ply", 2216, 4520},
    {"plate_holes-aligned", "plate_holes.ply", 618, 1252},
    {"anchor-aligned", "anchor.ply", 519, 1050},
    {"boeing-aligned", "boeing.ply", 2741, 2564},
    {"cheese-aligned", "cheese.ply", 8629, 17786},
    {"tube-aligned", "tube.ply", 560, 1120}};

/// The scene with a box in the place of the mesh, so that its motion can be tested anywhere.
Scene with_stand_in(const char* name) {
    nlohmann::json document = nlohmann::json::parse(find_builtin(name)->json);
    for (nlohmann::json& model : document["models"])
        model = {{"name", model["name"]}, {"box", nlohmann::json::object()}};
    return parse_scene(document.dump(), {name, {}, {}});
}

/// The rotation about x, then y, then z, by angles in degrees, multiplied out.
Mat3 euler(double about_x, double about_y, double about_z) {
    constexpr double degree = std::numbers::pi / 180;
    const double sx = std::sin(about_x * degree), cx = std::cos(about_x * degree),
                 sy = std::sin(about_y * degree), cy = std::cos(about_y * degree),
                 sz = std::sin(about_z * degree), cz = std::cos(about_z * degree);
    Mat3 m;
    m << cy * cz, sx * sy * cz - cx * sz, cx * sy * cz + sx * sz,  //
        cy * sz, sx * sy * sz + cx * cz, cx * sy * sz - sx * cz,   //
        -sy, sx * cy, cx * cy;
    return m;
}

void expect_pose(const Body& body, int frame, const Mat3& rotation, const Vec3& translation) {
    const Pose pose = pose_at(body.motion, frame);
    EXPECT_LT((pose.rotation - rotation).cwiseAbs().maxCoeff(), 1e-13)
        << body.name << " at frame " << frame;
    EXPECT_LT((pose.translation - translation).cwiseAbs().maxCoeff(), 1e-15)
        << body.name << " at frame " << frame;
}

/// Both bodies turn by Euler angles, and B's center moves along x.
void expect_turning_apart(const char* name, double from, double to) {
    SCOPED_TRACE(name);
    const Scene scene = with_stand_in(name);
    ASSERT_EQ(scene.frames, 500);
    ASSERT_EQ(scene.bodies.size(), 2u);
    for (const int i : {0, 1, 77, 123, 250, 388, 498, 499}) {
        expect_pose(scene.bodies[0], i, euler(0.9 * i + 10, 1.3 * i, 0.7 * i), Vec3::Zero());
        expect_pose(scene.bodies[1], i, euler(-1.1 * i, 0.8 * i + 50, 1.7 * i + 20),
                    Vec3(from + (to - from) * i / 499, 0, 0));
    }
    EXPECT_EQ(pose_at(scene.bodies[1].motion, 499).translation, Vec3(to, 0, 0));
}

TEST(BuiltinMeshes, TurnTheHorsesByEulerAnglesAndDrawThemApartAlongX) {
    expect_turning_apart("horses", 0.1, 0.7);
}

TEST(BuiltinMeshes, TurnCadModelsAsTheHorsesAndBeginAndEndThemCloserToEachOther) {
    for (const std::string_view name : cad_scenes)
        expect_turning_apart(std::string(name).c_str(), 0.05, 0.5);
}

TEST(BuiltinMeshes, MoveAlignedCadModelsAlongXWithoutATurn) {
    for (const std::string_view name : aligned_scenes) {
        if (!name.ends_with("-aligned")) continue;
        const Scene scene = with_stand_in(std::string(name).c_str());
        ASSERT_EQ(scene.frames, 50);
        for (const int i : {0, 17, 49}) {
            expect_pose(scene.bodies[0], i, Mat3::Identity(), Vec3::Zero());
            expect_pose(scene.bodies[1], i, Mat3::Identity(), Vec3(0.02 + 0.48 * i / 49, 0, 0));
        }
    }
}

TEST(BuiltinMeshes, MoveOneHandAndOneDragonAlongYThroughTheOther) {
    for (const char* name : {"hands", "dragons"}) {
        const Scene scene = with_stand_in(name);
        ASSERT_EQ(scene.frames, 500);
        ASSERT_EQ(scene.bodies.size(), 2u);
        for (const int i : {0, 1, 77, 250, 498, 499}) {
            expect_pose(scene.bodies[0], i, Mat3::Identity(), Vec3::Zero());
            expect_pose(scene.bodies[1], i, euler(20, 35, 0),
                        Vec3(0.05, 0.9 - 1.8 * i / 499, 0.03));
        }
    }
}

TEST(BuiltinMeshes, MoveRigidlyInEveryFrame) {
    for (const SceneWithMesh& made : scenes_with_meshes)
        for (const Body& body : with_stand_in(made.name).bodies)
            for (int frame = 0; frame < 500; ++frame)
                EXPECT_LT(rigidity_defect(pose_at(body.motion, frame)), 1e-14);
}

TEST(BuiltinMeshes, AreNamedWithCountsAndPublicationWhereTheyAreMissing) {
    const std::string advice = "; name the folder that holds it with --models DIR or SCB_MODELS.";
    EXPECT_EQ(refusal([] { load_scene({"horses"}); }),
              "built-in horses: models[0].file: there is no mesh file horse.ply (48485 vertices "
              "and 96966 triangles; published: Large Geometric Models Archive of Georgia Tech, "
              "horse, a Cyberware scan)" +
                  advice);
    const TemporaryFolder models;
    const LoadOptions options{models.path, {}};
    EXPECT_EQ(refusal([&] { load_scene({"hands"}, options); }),
              "built-in hands: models[0].file: there is no mesh file skeleton_hand.ply in " +
                  models.path.string() +
                  " (57065 vertices and 114037 triangles; published: myo_sim of MyoHub, hand, the "
                  "meshes of its 27 bones in the neutral pose, joined)" +
                  advice);
    EXPECT_EQ(refusal([] { load_scene({"dragons"}); }),
              "built-in dragons: models[0].file: there is no mesh file dragon.ply (437645 "
              "vertices and 871414 triangles; published: Stanford 3D Scanning Repository, dragon, "
              "dragon_vrip.ply)" +
                  advice);
    for (const SceneWithMesh& made : scenes_with_meshes) {
        EXPECT_EQ(find_builtin(made.name)->mesh_files, std::vector<std::string>{made.file});
        const std::string missing = refusal([&] { load_scene({made.name}); });
        expect_in(std::string("there is no mesh file ") + made.file + " (" +
                      std::to_string(made.vertices) + " vertices and " +
                      std::to_string(made.triangles) + " triangles; published: ",
                  missing);
    }
    EXPECT_TRUE(find_builtin("spheres-l1")->mesh_files.empty());
}

TEST(BuiltinMeshes, AreRefusedWhereAnotherMeshHasTheirName) {
    const TemporaryFolder models;
    const std::string file = models.write("horse.ply",
                                          "ply\nformat ascii 1.0\nelement vertex 3\n"
                                          "property float x\nproperty float y\nproperty float z\n"
                                          "element face 1\nproperty list uchar int vertex_indices\n"
                                          "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_in("built-in horses: models[0].file: " + file +
                  " has 3 vertices and 1 triangle, but the scene was made for 48485 vertices and "
                  "96966 triangles",
              refusal([&] {
                  load_scene({"horses"}, {models.path, {}});
              }));
}

TEST(BuiltinMeshes, LoadIntoAUnitBoxWithTheirCounts) {
    bool any = false;
    for (const SceneWithMesh& made : scenes_with_meshes) {
        if (!has_model_file(made.file, std::string(made.name) + " with its mesh")) continue;
        any = true;
        const Scene scene = load_scene({made.name}, {models_folder(), {}});
        SCOPED_TRACE(scene.name);
        EXPECT_EQ(scene.name, made.name);
        EXPECT_TRUE(scene.camera);
        ASSERT_EQ(scene.meshes.size(), 1u);  // both bodies share it
        const Mesh& mesh = scene.meshes[0].mesh;
        EXPECT_EQ(mesh.vertices.size(), made.vertices);
        EXPECT_EQ(mesh.triangles.size(), made.triangles);
        const Box box = bounding_box(mesh);
        EXPECT_EQ((box.upper - box.lower).maxCoeff(), 1);
        EXPECT_LT((box.upper + box.lower).cwiseAbs().maxCoeff(), 1e-15);
    }
    if (!any) GTEST_SKIP();
}

}  // namespace
}  // namespace scb::scenes
