#include "scenes/scene/load_scene.h"

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

const char* const obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(LoadScene, TakesABuiltInName) {
    const Scene scene = load_scene({"knots-l1"});
    EXPECT_EQ(scene.name, "knots-l1");
    EXPECT_EQ(scene.frames, 500);
}

TEST(LoadScene, TakesASceneFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write("mine.json", R"({"scb_scene": 1, "name": "mine",
        "models": [{"name": "m", "box": {}}], "bodies": [{"name": "A", "model": "m"}]})");
    EXPECT_EQ(load_scene({file}).name, "mine");
}

TEST(LoadScene, MakesASceneOfOneFrameFromOneMesh) {
    const TemporaryFolder folder;
    const Scene scene = load_scene({folder.write("my horse.v2.obj", obj_triangle)});
    EXPECT_EQ(scene.name, "my-horse.v2");
    EXPECT_EQ(scene.meshes[0].name, "my horse.v2");
    EXPECT_EQ(scene.frames, 1);
    EXPECT_FALSE(scene.camera);
    EXPECT_EQ(scene.bodies.size(), 1u);
}

TEST(LoadScene, PlacesTheSecondOfTwoMeshes) {
    const TemporaryFolder folder;
    const std::string a = folder.write("a.obj", obj_triangle),
                      b = folder.write("b.obj", obj_triangle);
    Pose pose;
    pose.rotation = rotation_about(Vec3::UnitZ(), 90);
    pose.translation = Vec3(1, 2, 3);
    const Scene scene = load_scene({a, b}, {{}, pose});
    EXPECT_EQ(scene.name, "a-b");
    EXPECT_EQ(scene.bodies[0].name, "a");
    EXPECT_EQ(scene.bodies[1].name, "b");
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(pose_at(scene.bodies[0].motion, 0).rotation, Mat3(Mat3::Identity()));
    EXPECT_EQ(pose_at(scene.bodies[1].motion, 0).rotation, pose.rotation);
    EXPECT_EQ(pose_at(scene.bodies[1].motion, 5).translation, pose.translation);
    pose.rotation *= 1.001;
    expect_in("--pose: the pose is not rigid", refusal([&] { load_scene({a, b}, {{}, pose}); }));
}

TEST(LoadScene, SharesTheMeshOfAFileNamedTwice) {
    const TemporaryFolder folder;
    const std::string a = folder.write("a.obj", obj_triangle);
    const Scene scene = load_scene({a, (folder.path / "." / "a.obj").string()});
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.bodies.size(), 2u);
    EXPECT_EQ(scene.bodies[1].mesh, 0u);
    EXPECT_EQ(scene.name, "a-a");
    EXPECT_EQ(scene.bodies[0].name, "a-A");
    EXPECT_EQ(scene.bodies[1].name, "a-B");
}

TEST(LoadScene, SaysWhatCanBeNamed) {
    const std::string sentence = refusal([] { load_scene({"sphere-l1"}); });
    expect_in("sphere-l1: there is no such scene or file, did you mean spheres-l1?", sentence);
    expect_in("horses, hands", sentence);
    EXPECT_EQ(refusal([] { load_scene({"zebra"}); }).find("did you mean"), std::string::npos);
    EXPECT_EQ(refusal([] { load_scene({"gone/horse.ply"}); }),
              "gone/horse.ply: there is no such file; check the path.");
    expect_in("0 names are given", refusal([] { load_scene({}); }));
    expect_in("3 names are given", refusal([] { load_scene({"a", "b", "c"}); }));
    expect_in("this is a scene by itself", refusal([] { load_scene({"spheres-l1", "b.obj"}); }));
    expect_in("--pose: it places the second", refusal([] {
                  load_scene({"spheres-l1"}, {{}, Pose{}});
              }));
    const TemporaryFolder folder;
    expect_in("this is a directory", refusal([&] { load_scene({folder.path.string()}); }));
    expect_in("cannot be reached (File name too long)",
              refusal([] { load_scene({std::string(300, 'a') + ".obj"}); }));
}

TEST(LoadScene, LooksForMeshesInTheFolderOfModelsToo) {
    const TemporaryFolder models;
    models.write("only-there.obj", obj_triangle);
    const LoadOptions options{models.path, {}};
    EXPECT_EQ(load_scene({"only-there.obj"}, options).name, "only-there");
    EXPECT_EQ(load_scene({"only-there.obj", "only-there.obj"}, options).meshes.size(), 1u);
    EXPECT_EQ(refusal([&] { load_scene({"gone.obj"}, options); }),
              "gone.obj: there is no such file, nor is there " + (models / "gone.obj") +
                  "; check the path.");
    EXPECT_EQ(refusal([&] { load_scene({"/gone.obj"}, options); }),
              "/gone.obj: there is no such file; check the path.");
    expect_in("there is no such scene or file", refusal([&] { load_scene({"zebra"}, options); }));

    const TemporaryFolder here;
    const std::string near = here.write("only-there.obj", std::string(obj_triangle) + "f 3 2 1\n");
    EXPECT_EQ(load_scene({near}, options).meshes[0].mesh.triangles.size(), 2u);
}

TEST(LoadScene, KeepsBytesThatAreNotUtf8OutOfNames) {
    const TemporaryFolder folder;
    const std::pair<const char*, const char*> names[] = {
        {"h\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80", "h\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80"},
        {"a\xff\xfe", "a??"},
        {"a\xc3", "a?"},
        {"a\xe2\x82z", "a??z"},
        {"a\xc0\xaf", "a??"},
        {"a\xed\xa0\x80", "a???"},
    };
    for (const auto& [bytes, name] : names) {
        const std::string file = folder.write(std::string(bytes) + ".obj", obj_triangle);
        const Scene scene = load_scene({file});
        EXPECT_EQ(scene.meshes[0].name, name);
        EXPECT_EQ(scene.bodies[0].name, name);
    }
}

TEST(LoadScene, MakesFileNamesOfAnyText) {
    EXPECT_EQ(file_name_of("a b//c"), "a-b-c");
    EXPECT_EQ(file_name_of("..hidden--"), "hidden");
    EXPECT_EQ(file_name_of("//"), "scene");
    // What is lost must not make two names one.
    const std::string e = "\xc3\xa9", o = "\xc3\xb6";
    EXPECT_TRUE(file_name_of(e).starts_with("scene-"));
    EXPECT_TRUE(file_name_of("m" + e + "n").starts_with("m-n-"));
    EXPECT_NE(file_name_of("m" + e + "n"), file_name_of("m" + o + "n"));
    const std::string longest(100, 'x');
    EXPECT_EQ(file_name_of(longest), longest);
    EXPECT_NE(file_name_of(longest + "a"), file_name_of(longest + "b"));
    EXPECT_EQ(file_name_of(longest + "a").size(), 100u);
}

}  // namespace
}  // namespace scb::scenes
