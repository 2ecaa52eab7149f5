#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

const char* const scene_text = R"({
  "scb_scene": 1, "name": "small", "frames": 2,
  "models": [{"name": "wedge", "file": "wedge.obj"}, {"name": "flat", "file": "flat.gltf"}],
  "bodies": [{"name": "left", "model": "wedge"},
             {"name": "right", "model": "flat", "poses": "log.csv"}]
})";
const char* const wedge_text =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const char* const flat_text =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "flat.bin"}]})";
const char* const pairs_text =
    R"([{"a": {"center": [0, 0, 0], "radius": 1}, "b": {"center": [1, 0, 0], "radius": 1}}])";
const char* const suite_text = R"({"scb_golden": 1, "cases": [
  {"name": "one", "run": "collide", "scene": "scene.json", "frames": "0"},
  {"name": "two", "run": "collide", "scene": ["wedge.obj", "wedge.obj"], "frames": "0",
   "arguments": ["--poses=moves.csv"]}]})";

/// A command, the files that it reads, and its option for the output: a folder, or a file of that
/// name.
struct Row {
    std::string command;
    std::vector<std::string> inputs;
    std::string option, name;
};

std::vector<Row> rows() {
    const std::vector<std::string> of_scene = {"scene.json", "wedge.obj", "flat.gltf", "flat.bin",
                                               "log.csv"};
    const auto of_scene_and = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = of_scene;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const std::vector<std::string> with_camera = of_scene_and({"camera.json"}),
                                   of_trace = of_scene_and({"t.scbrec", "camera.json"}),
                                   of_suite = of_scene_and({"suite.json", "moves.csv"});
    const std::string picture = " --size 320x240 --samples 1 --camera camera.json";
    return {
        {"render levels scene.json --levels 0,1 --ids" + picture, with_camera, "-o", ""},
        {"render pairs scene.json --frames 0,1 --ids --sheet" + picture, with_camera, "-o", ""},
        {"render rejections scene.json --ids --sheet" + picture, with_camera, "-o", ""},
        {"render traversal scene.json --size 640x480", of_scene, "-o", ""},
        {"render pairs t.scbrec --frames 0" + picture, of_trace, "-o", ""},
        {"render pairs scene.json -o elsewhere" + picture, with_camera, "--video", "out.mp4"},
        {"inspect scene.json --frames 0 --size 640x480", of_scene, "-o", ""},
        {"explain scene.json --frames 0 --pair 0,0" + picture, with_camera, "-o", ""},
        {"explain t.scbrec --frames 0 --pair 0,0" + picture, of_trace, "-o", ""},
        {"explain --pairs pairs.json" + picture, {"pairs.json", "camera.json"}, "-o", ""},
        {"tune scene.json --frames 0 --no-time", of_scene, "-o", ""},
        {"bench scene.json --frames 0 --repeat 1 --volume scb", of_scene, "-o", ""},
        {"collide scene.json --frames 0", of_scene, "--pairs-out", "out.csv"},
        {"collide wedge.obj wedge.obj --poses log.csv --expect expected.csv",
         {"wedge.obj", "log.csv", "expected.csv"},
         "--pairs-out",
         "out.csv"},
        {"trace scene.json --frames 0", of_scene, "-o", "out.scbrec"},
        {"convert r.scbrec t.jsonl", {"r.scbrec", "t.jsonl"}, "-o", "out.scbrec"},
        {"export scene.json --levels 0", of_scene, "-o", "out.ply"},
        {"golden check --suite suite.json", of_suite, "--json", "out.json"},
        {"golden check --suite suite.json", of_suite, "--junit", "out.xml"},
        {"golden check --suite suite.json", of_suite, "--report", ""},
        {"golden report --from results.json", {"results.json"}, "--json", "out.json"},
        {"golden report --from results.json", {"results.json"}, "--junit", "out.xml"},
        {"golden report --from results.json", {"results.json"}, "--report", ""},
    };
}

struct InputsAndOutputs : testing::Test {
    InputsAndOutputs() {
        folder.write("scene.json", scene_text);
        folder.write("wedge.obj", wedge_text);
        folder.write("flat.gltf", flat_text);
        std::string numbers;
        for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 1.f})
            numbers.append(reinterpret_cast<const char*>(&number), sizeof number);
        folder.write("flat.bin", numbers);
        folder.write("log.csv", "0.1 0.1 0.1 0 0 0 1\n0.1 0.1 0.1 0 0 0 1\n");
        folder.write("moves.csv", "0 0 0.5 0 0 0 1\n");
        folder.write("expected.csv", "frame,triangle_a,triangle_b\n");
        folder.write("camera.json", R"({"azimuth": 10})");
        folder.write("pairs.json", pairs_text);
        folder.write("suite.json", suite_text);
        EXPECT_EQ(run("trace scene.json -o t.scbrec").status, 0);
        EXPECT_EQ(run("trace scene.json --records -o r.scbrec").status, 0);
        EXPECT_EQ(run("convert r.scbrec -o t.jsonl").status, 0);
        run("golden check --suite suite.json --json results.json");
    }

    ProgramRun run(const std::string& arguments) const {
        return run_scb(arguments, {folder.path.string(), {"GITHUB_STEP_SUMMARY"}});
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path))
            if (entry.is_regular_file())
                all[entry.path().filename().string()] = file_text(entry.path());
        return all;
    }
    /// What a run of the command writes that nothing keeps from it.
    std::vector<std::string> outputs(const Row& row) const {
        if (!row.name.empty()) return {row.name};
        run(row.command + " " + row.option + " free");
        std::vector<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / "free"))
            names.push_back("out/" + entry.path().filename().string());
        fs::remove_all(folder.path / "free");
        return names;
    }

    TemporaryFolder folder;
};

// The name of the output is a second name of the input.
TEST_F(InputsAndOutputs, NeverMeet) {
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.command + " " + row.option);
        if (row.option == "--video" && std::system("command -v ffmpeg >/dev/null") != 0) {
            std::fputs("NOT TESTED: videos, since ffmpeg is missing.\n", stderr);
            continue;
        }
        const std::vector<std::string> names = outputs(row);
        EXPECT_FALSE(names.empty());
        const auto before = contents();
        for (std::size_t n = 0; n < names.size(); ++n)
            for (std::size_t i = 0; i < row.inputs.size(); ++i) {
                const std::string &name = names[n], &input = row.inputs[i];
                fs::create_directory(folder.path / "out");
                fs::create_hard_link(folder.path / input, folder.path / name);
                const ProgramRun refused =
                    run(row.command + " " + row.option + (row.name.empty() ? " out" : " " + name));
                EXPECT_EQ(refused.status, 2) << input << " as " << name << ": " << refused.err;
                EXPECT_NE(refused.err.find("would replace"), std::string::npos)
                    << input << " as " << name << ": " << refused.err;
                EXPECT_EQ(fs::hard_link_count(folder.path / input), 2u) << input << " as " << name;
                fs::remove(folder.path / name);
                fs::remove_all(folder.path / "out");
                EXPECT_EQ(contents(), before) << input << " as " << name;
            }
    }
}

// Which files the mesh of a case names is known only where the case has run.
TEST_F(InputsAndOutputs, ReplaceOnlyResultsWhereInputsAreNotKnown) {
    folder.write("broken.json", R"({"scb_golden": 1, "cases": [
  {"name": "one", "run": "collide", "scene": "scene.json", "frames": "0"},
  {"name": "two", "run": "collide", "scene": "gone.json", "frames": "0"}]})");
    for (const char* option : {"--json", "--junit"})
        for (const char* cases : {"", "two"}) {
            const std::string command =
                std::string("golden check --suite broken.json ") + cases + " " + option;
            const auto before = contents();
            const ProgramRun refused = run(command + " flat.bin");
            EXPECT_EQ(refused.status, 2) << refused.err;
            EXPECT_NE(refused.err.find("would replace flat.bin"), std::string::npos) << refused.err;
            EXPECT_EQ(contents(), before);
            for (int i = 0; i < 2; ++i) EXPECT_EQ(run(command + " results").status, 1) << command;
            fs::remove(folder.path / "results");
        }
}

}  // namespace
}  // namespace scb::app
