#include "scenes/scene/scene_file.h"

#include <nlohmann/json.hpp>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

const char* const small_scene = R"({
  "scb_scene": 1, "name": "small", "frames": 10, "default_frame": 3,
  "models": [{"name": "ball", "icosphere": {"subdivisions": 1}}, {"name": "crate", "box": {"size": [1, 2, 3]}}],
  "bodies": [
    {"name": "A", "model": "ball"},
    {"name": "B", "model": "crate", "position": {"from": [0, 0, 0], "to": [9, 0, 0], "frames": 9},
     "rotation": [{"axis": [0, 0, 1], "per_frame": 90}]}
  ]
})";

Scene parse(const std::string& text) { return parse_scene(text, {"my.json", {}, {}}); }

/// The error about the small scene after a change at a JSON pointer; no value removes the field.
std::string refused(const std::string& pointer, const json& value) {
    json document = json::parse(small_scene);
    document[json::json_pointer(pointer)] = value;
    return refusal([&] { parse(document.dump()); });
}

std::string refused_without(const std::string& parent, const std::string& name) {
    json document = json::parse(small_scene);
    document[json::json_pointer(parent)].erase(name);
    return refusal([&] { parse(document.dump()); });
}

TEST(SceneFile, IsReadInFull) {
    const Scene scene = parse(small_scene);
    EXPECT_EQ(scene.name, "small");
    EXPECT_EQ(scene.frames, 10);
    EXPECT_EQ(scene.default_frame, 3);
    EXPECT_FALSE(scene.camera);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].mesh.triangles.size(), 80u);
    ASSERT_EQ(scene.bodies.size(), 2u);
    EXPECT_EQ(scene.bodies[1].mesh, 1u);
    const Pose pose = pose_at(scene.bodies[1].motion, 1);
    EXPECT_EQ(pose.translation, Vec3(1, 0, 0));
    EXPECT_EQ(transform_direction(pose, Vec3::UnitX()), Vec3(0, 1, 0));
}

TEST(SceneFile, AZeroByteIsNoEnd) {
    const std::string text = small_scene;
    expect_in("a zero byte", refusal([&] { parse(text + std::string(1, '\0')); }));
    expect_in("a zero byte", refusal([&] { parse(text + std::string("\0 {", 3)); }));
}

TEST(SceneFile, NamesFileAndPlaceOfAWrongValue) {
    EXPECT_EQ(refused("/bodies/1/rotation/0/axis", "x"),
              "my.json: bodies[1].rotation[0].axis: expected three numbers, found \"x\".");
    EXPECT_EQ(refused("/frames", 0),
              "my.json: frames: expected a whole number from 1 to 1000000, found 0.");
    expect_in("my.json: frames: expected a whole number", refused("/frames", 1.5));
    expect_in("my.json: frames: expected a whole number", refused("/frames", -3));
    expect_in("my.json: frames: expected a whole number", refused("/frames", 1e300));
    expect_in("my.json: default_frame: expected a whole number from 0 to 9, found 10",
              refused("/default_frame", 10));
    expect_in("my.json: name: expected", refused("/name", "a/b"));
    expect_in("my.json: name: expected", refused("/name", ".."));
    expect_in("my.json: name: expected a text in quotes, found 7", refused("/name", 7));
    expect_in("my.json: scb_scene: expected", refused("/scb_scene", 2));
    expect_in("my.json: bodies: expected at least one body", refused("/bodies", json::array()));
    expect_in("my.json: models: expected a list of models, found an object",
              refused("/models", json::object()));
    expect_in("my.json: bodies[0]: expected an object, found 3", refused("/bodies/0", 3));
    expect_in("bodies[1].rotation[0].axis: expected three numbers that are not all zero",
              refused("/bodies/1/rotation/0/axis", {0, 0, 0}));
    expect_in("bodies[1].position.frames: expected a number from",
              refused("/bodies/1/position/frames", 0));
    expect_in("bodies[0].position: expected three numbers, or an object",
              refused("/bodies/0/position", "here"));
    expect_in("bodies[0].position[1]: expected a number from -1e+70 to 1e+70",
              refused("/bodies/0/position", {0, 1e200, 0}));
    expect_in("bodies[0].model: there is no model \"bal\"; the models are ball, crate.",
              refused("/bodies/0/model", "bal"));
    expect_in("bodies[1].name: the name \"A\" is taken", refused("/bodies/1/name", "A"));
    expect_in("models[1].name: the name \"ball\" is taken", refused("/models/1/name", "ball"));
    expect_in("camera.elevation: expected a number from -90 to 90, found 100",
              refused("/camera", {{"elevation", 100}}));
}

TEST(SceneFile, RefusesUnknownMissingAndRepeatedFields) {
    expect_in("my.json: unknown field \"frame\"; known are scb_scene, name,", refused("/frame", 3));
    expect_in("my.json: bodies[0]: unknown field \"spin\"", refused("/bodies/0/spin", 3));
    expect_in("my.json: models[0].icosphere: unknown field \"levels\"",
              refused("/models/0/icosphere/levels", 3));
    expect_in("my.json: the field \"scb_scene\" is missing", refused_without("", "scb_scene"));
    expect_in("my.json: the field \"models\" is missing", refused_without("", "models"));
    expect_in("my.json: bodies[1]: the field \"model\" is missing",
              refused_without("/bodies/1", "model"));
    expect_in("my.json: bodies[1].position: the field \"to\" is missing",
              refused_without("/bodies/1/position", "to"));
    expect_in("my.json: line 2, column 6: the field \"name\" stands twice",
              refusal([] { parse("{\"name\": \"a\",\n\"name\": \"b\"}"); }));
    expect_in("models[0]: expected exactly one of file, icosphere",
              refused("/models/0/box", json::object()));
    expect_in("models[0]: expected exactly one of", refused_without("/models/0", "icosphere"));
}

TEST(SceneFile, NamesLineAndColumnOfBrokenJson) {
    expect_in("my.json: line 2, column 12: not valid JSON",
              refusal([] { parse("{\n  \"frames\" 3\n}"); }));
    expect_in("my.json: line 1, column ", refusal([] { parse("{\"frames\": NaN}"); }));
    expect_in("my.json: line 1, column 1: not valid JSON", refusal([] { parse(""); }));
    expect_in("my.json: line 2, column 15: not valid JSON: number overflow parsing '1e999'",
              refusal([] { parse("{\n\"frames\": 1e999}"); }));
    expect_in("not valid JSON", refusal([] { parse("{\"name\": \"\xff\"}"); }));
    expect_in("my.json: expected an object, found [1,2]", refusal([] { parse("[1, 2]"); }));
    expect_in("not valid JSON", refusal([] { parse(std::string(50, '[')); }));
    for (const std::size_t length : {10u, 50u, 120u, 300u})
        expect_in("not valid JSON",
                  refusal([&] { parse(std::string(small_scene).substr(0, length)); }));
}

TEST(SceneFile, RefusesDeepNestingEverywhere) {
    std::string objects, ends;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":", ends += '}';
    for (const std::string& deep :
         {std::string(100000, '[') + std::string(100000, ']'), objects + "1" + ends}) {
        expect_in("nested more than 100 deep", refusal([&] { parse(deep); }));
        std::string inside = small_scene;
        inside.replace(inside.find("\"small\""), 7, deep);
        expect_in("nested more than 100 deep", refusal([&] { parse(inside); }));
    }
}

TEST(SceneFile, RefusesNamesThatAreEmptyOrHaveControlCharacters) {
    for (const std::string& name : {std::string(), std::string("a\nb"), std::string("\x1b[2J"),
                                    std::string("a\0b", 3), std::string("\x7f")})
        for (const char* pointer :
             {"/bodies/0/name", "/bodies/0/model", "/models/0/name", "/models/2/file"}) {
            json document = json::parse(small_scene);
            if (std::string(pointer) == "/models/2/file")
                document["models"].push_back({{"name", "third"}});
            document[json::json_pointer(pointer)] = name;
            const std::string sentence = refusal([&] { parse(document.dump()); });
            expect_in("expected a text that is not empty and has no control characters", sentence);
            EXPECT_EQ(sentence.find_first_of(std::string("\n\x1b\0\x7f", 4)), sentence.npos);
        }
    for (const char* name : {"a/b", "../up", "two words", "-x", "\x1b[2J", ""})
        expect_in("my.json: name: expected at most 100 letters", refused("/name", name));
    // Only the scene's name goes into file names.
    json document = json::parse(small_scene);
    document["bodies"][0]["name"] = "left/h\xc3\xa9";
    EXPECT_EQ(parse(document.dump()).bodies[0].name, "left/h\xc3\xa9");
}

TEST(SceneFile, TakesManyBodies) {
    json document = json::parse(small_scene);
    for (int i = 0; i < 98; ++i)
        document["bodies"].push_back({{"name", "n" + std::to_string(i)}, {"model", "ball"}});
    EXPECT_EQ(parse(document.dump()).bodies.size(), 100u);
}

TEST(SceneFile, RefusesCountsBeforeMemoryIsSpent) {
    const auto model = [](const char* shape, const json& fields) {
        json document = json::parse(small_scene);
        document["models"].push_back({{"name", "huge"}, {shape, fields}});
        return refusal([&] { parse(document.dump()); });
    };
    const int huge = 2147483647;
    expect_in("models[2].icosphere", model("icosphere", {{"subdivisions", huge}}));
    expect_in("models[2].box", model("box", {{"subdivisions", huge}}));
    expect_in("models[2].plane", model("plane", {{"cells", {1 << 24, 1 << 24}}}));
    for (const char* shape : {"cone", "cylinder"})
        expect_in(shape, model(shape, {{"sides", huge}, {"segments", huge}}));
    expect_in("models[2].torus_knot", model("torus_knot", {{"sides", huge}, {"rings", huge}}));
    expect_in("models[2].soup", model("soup", {{"count", huge}}));
    expect_in("models[2].soup", model("soup", {{"count", 1e18}}));
}

TEST(SceneFile, RefusesMeshesThatAreTooLargeOrImpossible) {
    EXPECT_EQ(refused("/models/0/icosphere/subdivisions", 40),
              "my.json: models[0].icosphere: subdivisions is 40; give 0 to 9.");
    expect_in("my.json: models[0].icosphere.radius: expected a number, found null",
              refused("/models/0/icosphere/radius", nullptr));
    expect_in("my.json: models[0].icosphere: radius is -1;",
              refused("/models/0/icosphere/radius", -1));
    expect_in("my.json: models[1].scale: expected a number above 0", refused("/models/1/scale", 0));
    expect_in("my.json: models[1].normalize: expected \"unit-box\"",
              refused("/models/1/normalize", "box"));
#ifndef SCB_SANITIZED  // they are made first
    json document = json::parse(small_scene);
    for (int i = 0; i < 8; ++i)
        document["models"].push_back(
            {{"name", "big" + std::to_string(i)}, {"plane", {{"cells", {2048, 2048}}}}});
    expect_in("models[7]: the models that are made by formula take more than 1024 MiB together",
              refusal([&] { parse(document.dump()); }));
#endif
}

TEST(SceneFile, NamesAFewOfManyModels) {
    json document = json::parse(small_scene);
    for (int i = 10; i < 40; ++i)
        document["models"].push_back({{"name", "m" + std::to_string(i)}, {"box", json::object()}});
    document["bodies"][0]["model"] = "other";
    const std::string sentence = refusal([&] { parse(document.dump()); });
    expect_in("the models are ball, crate, m10, m11, ", sentence);
    expect_in("m27, ....", sentence);
}

TEST(SceneFile, PlacesABodyByTwelveNumbers) {
    json document = json::parse(small_scene);
    document["bodies"][0]["pose"] = {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7};
    const Scene scene = parse(document.dump());
    const Pose pose = pose_at(scene.bodies[0].motion, 4);
    EXPECT_EQ(pose.translation, Vec3(5, 6, 7));
    EXPECT_EQ(transform_direction(pose, Vec3::UnitX()), Vec3(0, 1, 0));
    expect_in("my.json: bodies[0].pose: the pose is not rigid",
              refused("/bodies/0/pose", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}));
    expect_in("bodies[0].pose: expected twelve numbers", refused("/bodies/0/pose", {1, 2, 3}));
    expect_in("bodies[1]: pose stands for both",
              refused("/bodies/1/pose", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
}

TEST(SceneFile, NormalizesScalesAndStoresRotatedInThisOrder) {
    json document = json::parse(small_scene);
    document["models"][1]["normalize"] = "unit-box";
    document["models"][1]["scale"] = 6;
    const Box box = bounding_box(parse(document.dump()).meshes[1].mesh);
    EXPECT_LT((box.upper - Vec3(1, 2, 3)).cwiseAbs().maxCoeff(), 1e-15);
    document["models"][1]["stored_rotation"] = {{"axis", {0, 0, 1}}, {"degrees", 90}};
    const Scene scene = parse(document.dump());
    // In a frame turned by 90 about z, what pointed along x points along -y.
    EXPECT_LT((bounding_box(scene.meshes[1].mesh).upper - Vec3(2, 1, 3)).cwiseAbs().maxCoeff(),
              1e-15);
    const Mat3 turn = rotation_about(Vec3::UnitZ(), 90);
    document["models"][1].erase("stored_rotation");
    const Scene plain = parse(document.dump());
    for (std::size_t i = 0; i < plain.meshes[1].mesh.vertices.size(); ++i)
        EXPECT_LT(
            (rotate(turn, scene.meshes[1].mesh.vertices[i]) - plain.meshes[1].mesh.vertices[i])
                .norm(),
            1e-15);
}

TEST(SceneFile, RepeatsAMeshAlongTheAxes) {
    json document = json::parse(small_scene);
    const Mesh one = parse(document.dump()).meshes[1].mesh;
    document["models"][1]["copies"] = {{"count", {3, 1, 2}}, {"step", {10, 20, -30}}};
    const Mesh all = parse(document.dump()).meshes[1].mesh;
    ASSERT_EQ(all.vertices.size(), 6 * one.vertices.size());
    ASSERT_EQ(all.triangles.size(), 6 * one.triangles.size());
    // x first, then y, then z.
    const Vec3 steps[] = {{0, 0, 0},   {10, 0, 0},   {20, 0, 0},
                          {0, 0, -30}, {10, 0, -30}, {20, 0, -30}};
    for (std::size_t copy = 0; copy < 6; ++copy)
        for (std::size_t i = 0; i < one.triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(all.vertices[all.triangles[copy * one.triangles.size() + i][k]],
                          Vec3(one.vertices[one.triangles[i][k]] + steps[copy]));
    expect_in(
        "my.json: models[1].copies.count: more than 8388608 triangles or vertices",
        refused("/models/1/copies", {{"count", {8388608, 8388608, 8388608}}, {"step", {1, 1, 1}}}));
    document["models"][1] = {{"name", "crate"},
                             {"soup", {{"count", 1}}},
                             {"copies", {{"count", {8388608, 2, 1}}, {"step", {1, 1, 1}}}}};
    expect_in("models[1].copies.count: more than 8388608 triangles or vertices",
              refusal([&] { parse(document.dump()); }));
    expect_in("models[1].copies.count: expected three whole numbers",
              refused("/models/1/copies", {{"count", {1, 2}}, {"step", {1, 1, 1}}}));
    expect_in("models[1].copies.count[1]: expected a whole number from 1 to 8388608",
              refused("/models/1/copies", {{"count", {1, 0, 1}}, {"step", {1, 1, 1}}}));
}

TEST(SceneFile, LooksForMeshesBesideItAndThenInTheFolderOfModels) {
    const TemporaryFolder scenes, models;
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string text =
        R"({"scb_scene": 1, "name": "x", "models": [{"name": "m", "file": "m.obj"}],
                                 "bodies": [{"name": "A", "model": "m"}]})";
    const std::string file = scenes.write("x.json", text);
    expect_in(file + ": models[0].file: there is no mesh file m.obj in " + scenes.path.string() +
                  " or " + models.path.string(),
              refusal([&] { load_scene_file(file, models.path); }));
    models.write("m.obj", triangle + "f 1 2 3\n");
    EXPECT_EQ(load_scene_file(file, models.path).meshes[0].mesh.triangles.size(), 2u);
    scenes.write("m.obj", triangle);
    EXPECT_EQ(load_scene_file(file, models.path).meshes[0].mesh.triangles.size(), 1u);
    scenes.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    const std::string sentence = refusal([&] { load_scene_file(file, models.path); });
    expect_in(file + ": models[0].file: ", sentence);
    expect_in("m.obj: the mesh has no triangles", sentence);
}

TEST(SceneFile, SaysOfAMissingMeshWhatItsModelDoes) {
    const auto missing = [](const json& fields, const std::string& file = "horse.ply") {
        json document = json::parse(small_scene);
        json& model = document["models"][0];
        model = {{"name", "ball"}, {"file", file}};
        model.update(fields);
        return refusal([&] { parse(document.dump()); });
    };
    const std::string start = "my.json: models[0].file: there is no mesh file horse.ply",
                      end = "; name the folder that holds it with --models DIR or SCB_MODELS.";
    EXPECT_EQ(missing(json::object()), start + end);
    EXPECT_EQ(missing({{"triangles", 7}}), start + " (7 triangles)" + end);
    EXPECT_EQ(missing({{"vertices", 5}, {"triangles", 7}}),
              start + " (5 vertices and 7 triangles)" + end);
    EXPECT_EQ(missing({{"published", "An Archive"}}), start + " (published: An Archive)" + end);
    EXPECT_EQ(missing({{"published", "An Archive"}, {"vertices", 5}}),
              start + " (5 vertices; published: An Archive)" + end);
    EXPECT_EQ(missing({{"published", "An Archive"}}, "/gone/horse.ply"),
              "my.json: models[0].file: there is no mesh file /gone/horse.ply (published: An "
              "Archive); check the path.");
    expect_in("models[0].vertices: expected a whole number from 1 to", missing({{"vertices", 0}}));
    expect_in("models[0].triangles: expected a whole number from 1 to",
              missing({{"triangles", "many"}}));
    expect_in("models[0].published: expected a text", missing({{"published", 3}}));
    expect_in("models[0].published: expected a text that is not empty",
              missing({{"published", "two\nlines"}}));
    for (const char* name : {"vertices", "triangles", "published"})
        expect_in(std::string("my.json: models[0].") + name + ": this describes a mesh file",
                  refused(std::string("/models/0/") + name, 80));
}

TEST(SceneFile, RefusesAMeshOfOtherCountsThanItsModelStates) {
    const TemporaryFolder folder;
    const std::string mesh =
        folder.write("m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n");
    const auto load = [&](const json& fields) {
        json model = {{"name", "m"}, {"file", "m.off"}, {"scale", 2}};
        model.update(fields);
        const json document = {{"scb_scene", 1},
                               {"name", "x"},
                               {"models", {model}},
                               {"bodies", {{{"name", "A"}, {"model", "m"}}}}};
        return load_scene_file(folder.write("x.json", document.dump()), {});
    };
    EXPECT_EQ(load({{"vertices", 4}, {"triangles", 2}}).meshes[0].mesh.triangles.size(), 2u);
    EXPECT_EQ(load({{"published", "An Archive"}}).meshes[0].mesh.vertices.size(), 4u);
    const std::string start = (folder / "x.json") + ": models[0].file: " + mesh +
                              " has 4 vertices and 2 triangles, but the scene was made for ";
    const std::string end = "; give that mesh, or a scene file with the counts of this one.";
    EXPECT_EQ(refusal([&] { load({{"vertices", 5}}); }), start + "5 vertices" + end);
    EXPECT_EQ(refusal([&] {
                  load({{"vertices", 4}, {"triangles", 3}});
              }),
              start + "4 vertices and 3 triangles" + end);
    EXPECT_EQ(refusal([&] {
                  load({{"triangles", 1}, {"published", "An Archive"}});
              }),
              start + "1 triangle (published: An Archive)" + end);
}

TEST(SceneFile, ExpressesTheHandsOfTheBenchmark) {
    const TemporaryFolder folder;
    folder.write("hand.obj", "v 0 0 0\nv 4 0 0\nv 0 2 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
    const std::string file =
        folder.write("hands.json", R"({"scb_scene": 1, "name": "hands", "frames": 500,
        "models": [{"name": "hand", "file": "hand.obj", "normalize": "unit-box"}],
        "bodies": [{"name": "A", "model": "hand"}, {"name": "B", "model": "hand",
          "position": {"from": [0.05, 0.9, 0.03], "to": [0.05, -0.9, 0.03], "frames": 499},
          "rotation": [{"axis": [1, 0, 0], "degrees": 20}, {"axis": [0, 1, 0], "degrees": 35}]}]})");
    const Scene scene = load_scene_file(file, {});
    const Box box = bounding_box(scene.meshes[0].mesh);
    EXPECT_EQ(box.lower, Vec3(-0.5, -0.25, -0.125));
    EXPECT_EQ(box.upper, Vec3(0.5, 0.25, 0.125));
    const Pose pose = pose_at(scene.bodies[1].motion, 250);
    EXPECT_NEAR(pose.translation[1], 0.9 - 1.8 * 250 / 499, 1e-15);
    const Mat3 expected = rotation_about(Vec3::UnitY(), 35) * rotation_about(Vec3::UnitX(), 20);
    EXPECT_LT((pose.rotation - expected).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace scb::scenes
