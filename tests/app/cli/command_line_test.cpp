#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(CommandLine, VersionNamesWhatDraws) {
    const ProgramRun run = run_scb("--version");
    EXPECT_EQ(run.status, 0);
    for (const char* name : {"scb ", "mesa ", "llvm ", "eigen ", "imgui "})
        EXPECT_NE(run.out.find(name), std::string::npos);
    EXPECT_EQ(run.err, "");
}

TEST(CommandLine, EveryCommandHasHelpWithAnExample) {
    for (const char* command : {"", "render levels", "collide", "bench", "trace", "diff", "stats",
                                "convert", "export", "scenes"}) {
        const ProgramRun run = run_scb(std::string(command) + " --help");
        EXPECT_EQ(run.status, 0) << command;
        EXPECT_NE(run.out.find("xample"), std::string::npos) << command;
        EXPECT_NE(run.out.find("  scb "), std::string::npos) << command;
    }
}

TEST(CommandLine, BadUsageIsOneSentenceAndStatus2) {
    for (const char* arguments : {"", "nonsense", "stats", "stats spheres-l1 --nonsense", "render",
                                  "render levels", "export spheres-l1", "stats a b c",
                                  "stats spheres-l1 --pose 1,2,3", "--color maybe scenes"}) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << arguments << run.err;
    }
}

struct Refusal {
    std::string arguments;
    int status;
    std::string sentence;  // a part of it
};

TEST(CommandLine, FilesMayBeginLikeOptions) {
    const TemporaryFolder folder;
    folder.write("-m.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const Surroundings there = {folder.path.string()};
    EXPECT_EQ(run_scb("stats -- -m.obj", there).status, 0);
    const ProgramRun tuned = run_scb("tune --no-time -- -m.obj -m.obj", there);
    EXPECT_NE(tuned.out.find("To use it: scb collide ./-m.obj ./-m.obj"), std::string::npos)
        << tuned.out << tuned.err;
    const ProgramRun refused = run_scb("stats -m.obj", there);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("'-m.obj' begins like an option; put -- before"), std::string::npos)
        << refused.err;
}

TEST(CommandLine, OptionsWithoutEffectAreNoted) {
    for (const auto& [arguments, said] :
         {std::pair<std::string, std::string>{
              "collide cone --frames 80 --volume obb --margin 0.1 --growth radius",
              "scb: --margin and --growth have no effect on obb.\n"},
          {"stats cone --volume aabb,ball --margin 0.1",
           "scb: --margin has no effect on aabb, ball.\n"},
          {"stats cone --volume scb,obb --margin 0.1 --growth radius", ""},
          {"collide cone --frames 80 --volume obb --margin 0.1 --quiet", ""}}) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 0) << arguments;
        EXPECT_EQ(run.err, said) << arguments;
    }
}

TEST(CommandLine, BadInputIsNamedAndNothingIsWritten) {
    const TemporaryFolder folder;
    write_text(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    write_text(folder / "nan.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
               "y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 nan "
               "0\n0 1 0\n3 0 1 2\n");
    write_text(folder / "index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    write_text(folder / "noise.stl", "this is not a mesh at all");
    write_text(folder / "broken.json", "{\"scb_scene\": 1,\n \"name\": }");
    write_text(folder / "field.json",
               R"({"scb_scene": 1, "name": "x", "sphere": 3, "models": [], "bodies": []})");
    write_text(folder / "file", "not a folder");
    const std::string out = folder / "out", small = " --size 320x240 -o " + out;
    const std::vector<Refusal> refusals = {
        {"stats missing.ply", 2, "missing.ply"},
        {"stats sphers-l1", 2, "spheres-l1"},
        {"stats " + (folder / "points.obj"), 2, "points.obj"},
        {"stats " + (folder / "nan.ply"), 2, "vertex 1"},
        {"stats " + (folder / "index.off"), 2, "7"},
        {"stats " + (folder / "noise.stl"), 2, "noise.stl"},
        {"stats " + folder.path.string(), 2, "directory"},
        {"stats " + (folder / "broken.json"), 2, "line 2"},
        {"stats " + (folder / "field.json"), 2, "sphere"},
        {"stats spheres-l1 --volume scb,cube", 2, "'cube' is not a volume"},
        {"stats spheres-l1 --growth fast", 2, "--growth fast"},
        {"stats spheres-l1 --split sah", 2, "--split sah"},
        {"stats spheres-l1 --threads 0", 2, "--threads 0"},
        {"stats spheres-l1 --volume ''", 2, "--volume: the value is empty"},
        {"stats spheres-l1 --growth ''", 2, "--growth '': give radius or ritter."},
        {"stats spheres-l1 --split ''", 2, "--split '': give paper or cost."},
        {"stats spheres-l1 --layout ''", 2, "--layout: the value is empty"},
        {"collide spheres-l1 --test ''", 2, "--test: the value is empty"},
        {"collide spheres-l1 --descent ''", 2, "--descent '': give radius, area"},
        {"bench spheres-l1 --layout ''", 2, "--layout: the value is empty"},
        {"bench spheres-l1 --simd ''", 2, "--simd: the value is empty"},
        {"stats spheres-l1 --layout float3", 2, "'float3' is not a layout"},
        {"stats spheres-l1 --layout reference", 2, "packed layouts alone"},
        {"bench spheres-l1 --layout float8,float8", 2, "is there twice"},
        {"stats spheres-l1 --margin -1", 2, "--margin"},
        {"stats " + (folder / "index.off") + " " + (folder / "index.off"), 2, "index.off"},
        {"render levels spheres-l1 --levels 99" + small, 2, "levels 0 to 1"},
        {"render levels spheres-l1 --levels 3:1" + small, 2, "names nothing"},
        {"render levels spheres-l1 --levels five" + small, 2, "'five' is not a whole number"},
        {"render levels spheres-l1 --levels 0:2000000000" + small, 2, "there is no level"},
        {"render levels spheres-l1 --levels ''" + small, 2, "--levels: the value is empty"},
        {"render levels spheres-l1 --levels 2 --frame 500" + small, 2, "frames 0 to 499"},
        {"render levels spheres-l1 --levels 2 --frame -1" + small, 2, "frames 0 to 499"},
        {"render levels spheres-l1 --levels 2 --size 0x0 -o " + out, 2, "--size 0x0"},
        {"render levels spheres-l1 --levels 2 --size 100000x100000 -o " + out, 2,
         "--size 100000x100000"},
        {"render levels spheres-l1 --levels 2 --size 640 -o " + out, 2, "WIDTHxHEIGHT"},
        {"render levels spheres-l1 --levels 2 --samples 3" + small, 2, "--samples 3"},
        {"render levels spheres-l1 --levels 2 --gl vulkan" + small, 2, "--gl vulkan"},
        {"render levels spheres-l1 --levels 2 --background pink" + small, 2, "--background pink"},
        {"render levels spheres-l1 --levels 2 --color-by mood" + small, 2, "--color-by mood"},
        {"render levels spheres-l1 --levels 2 --opacity 2" + small, 2, "--opacity"},
        {"render levels spheres-l1 --levels 2 --camera orbit:1" + small, 2, "--camera orbit:1"},
        {"render levels spheres-l1 --levels 2 --size 320x240 -o " + (folder / "file"), 3, "file"},
        {"render levels spheres-l1 --levels 2 --size 320x240 -o /proc/none", 3, "/proc/none"},
        {"export spheres-l1 --level 3 -o " + (folder / "level.xyz"), 2, ".xyz"},
        {"export spheres-l1 --level 3 -o /proc/none/level.ply", 3, "/proc/none/level.ply"},
        {"export spheres-l1 --level 3,4 -o " + (folder / "level.ply"), 2, "one level"},
        {"export spheres-l1 --level 3 --segments 1 -o " + (folder / "level.ply"), 2,
         "--segments 1"},
        {"stats horses --models " + folder.path.string(), 2,
         "(48485 vertices and 96966 triangles; "},
        {"scenes nonsense", 2, "'nonsense' is not a built-in scene"},
        {"stats spheres-l1 --mutation", 2, "--mutation: "},
        {"scenes ''", 2, "the value is empty"},
        {"golden check --shard ''", 2, "--shard: the value is empty"},
        {"stats spheres-l1 --models ''", 2, "--models: the value is empty"},
        {"collide spheres-l1 --bodies ''", 2, "--bodies: the value is empty"},
        {"render levels spheres-l1 --camera ''" + small, 2, "--camera: the value is empty"},
        {"render levels spheres-l1 --up ''" + small, 2, "--up '': give x, y or z"},
        {"render levels spheres-l1 --background ''" + small, 2, "--background '': give light"},
    };
    for (const Refusal& refusal : refusals) {
        const ProgramRun run = run_scb(refusal.arguments);
        EXPECT_EQ(run.status, refusal.status) << refusal.arguments << "\n" << run.err;
        EXPECT_NE(run.err.find(refusal.sentence), std::string::npos) << refusal.arguments << "\n"
                                                                     << run.err;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_EQ(run.out, "") << refusal.arguments;
        EXPECT_TRUE(!fs::exists(out) || files_in(out) == 0) << refusal.arguments;
        EXPECT_FALSE(fs::exists(folder / "level.ply"));
    }
}

TEST(CommandLine, TheReaderOfMeshesIsForTheProgramItself) {
    const ProgramRun run = run_scb_process("read-mesh bracket.ply 3>&-");
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("read-mesh is for scb itself"), std::string::npos) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
}

TEST(CommandLine, AFullDiskIsStatus3AndLeavesNoHalfFile) {
    const ProgramRun to_full = run_scb_process("stats spheres-l1 > /dev/full; exit $?; true");
    EXPECT_EQ(to_full.status, 3);
    const TemporaryFolder folder;
    // No file may grow past 4 KiB: pictures fail, and none is left behind.
    const ProgramRun limited = run_scb_process(
        "render levels soup --levels 3 --size 640x480 -o " + (folder / "out"), "ulimit -f 8;");
    EXPECT_EQ(limited.status, 3) << limited.err;
    EXPECT_EQ(lines_of(limited.err), 1u) << limited.err;
    EXPECT_EQ(files_in(folder / "out"), 0u);
}

TEST(CommandLine, AClosedStandardOutputIsStatus3) {
    const std::string closed = "sh -c 'exec \"$0\" \"$@\" <&- >&-'";
    const TemporaryFolder folder;
    const std::string out = " --size 320x240 -o " + (folder / "out");
    for (const std::string& command :
         {std::string("scenes"), std::string("stats cone"), "render levels soup --levels 3" + out,
          "inspect cone --frames 100" + out}) {
        const ProgramRun run = run_scb_process(command, closed);
        EXPECT_EQ(run.status, 3) << command;
        EXPECT_NE(run.err.find("cannot write to standard output"), std::string::npos) << run.err;
    }
    // Nobody hears about errors then, and nothing else is different.
    const std::string silent = "sh -c 'exec \"$0\" \"$@\" 2>&-'";
    EXPECT_EQ(run_scb_process("scenes", silent).status, 0);
    EXPECT_EQ(run_scb_process("scenes nonsense", silent).status, 2);
}

TEST(CommandLine, ScenesThatNeedMeshesSaySoAndShowTheirFiles) {
    const ProgramRun list = run_scb("scenes");
    ASSERT_EQ(list.status, 0);
    EXPECT_NE(list.out.find(" Needs horse.ply.\n"), std::string::npos) << list.out;
    EXPECT_NE(list.out.find(" Needs skeleton_hand.ply.\n"), std::string::npos) << list.out;
    EXPECT_NE(list.out.find("--models DIR"), std::string::npos) << list.out;
    const ProgramRun shown = run_scb("scenes horses");
    ASSERT_EQ(shown.status, 0);
    EXPECT_EQ(json::parse(shown.out)["models"][0]["triangles"], 96966);
}

TEST(CommandLine, SceneFilesOfBuiltInScenesGiveTheSame) {
    const TemporaryFolder folder;
    const ProgramRun shown = run_scb("scenes knots-l1");
    ASSERT_EQ(shown.status, 0);
    write_text(folder / "mine.json", shown.out);
    const json a = json::parse(run_scb("stats knots-l1 --json").out);
    const json b = json::parse(run_scb("stats " + (folder / "mine.json") + " --json").out);
    EXPECT_EQ(a["hierarchies"][0]["levels"], b["hierarchies"][0]["levels"]);
    EXPECT_EQ(a["hierarchies"][1]["levels"], b["hierarchies"][1]["levels"]);
}

TEST(CommandLine, StatsAddUp) {
    const ProgramRun run = run_scb("stats spheres-l1 --volume scb,ball,ritter,obb --json");
    ASSERT_EQ(run.status, 0);
    const json hierarchies = json::parse(run.out)["hierarchies"];
    ASSERT_EQ(hierarchies.size(), 8u);  // two meshes, four volumes
    for (const json& h : hierarchies) {
        std::size_t nodes = 0, leaves = 0;
        for (const json& level : h["levels"]) {
            nodes += level["nodes"].get<std::size_t>();
            leaves += level["leaves"].get<std::size_t>();
        }
        EXPECT_EQ(nodes, h["nodes"]);
        EXPECT_EQ(leaves, h["triangles"]);
        EXPECT_EQ(h["nodes"], 2 * h["triangles"].get<std::size_t>() - 1);
        EXPECT_GT(h["time"]["fit_ms"], 0);
    }
    // The ball of an SCB is the ball; Ritter's is no smaller.
    EXPECT_EQ(hierarchies[0]["levels"][7]["mean_diameter"],
              hierarchies[1]["levels"][7]["mean_diameter"]);
    EXPECT_GT(hierarchies[2]["levels"][7]["mean_diameter"],
              hierarchies[1]["levels"][7]["mean_diameter"]);

    const std::string table = run_scb("stats spheres-l1").out;
    EXPECT_NE(table.find("20,480 triangles"), std::string::npos);
    EXPECT_NE(table.find("longest side"), std::string::npos);
}

TEST(CommandLine, NamesFromOutsideDoNotSteerTheTerminal) {
    const ProgramRun run = run_scb("stats 'no\nfile\033[31m.off'");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    EXPECT_EQ(run.err.find('\033'), std::string::npos);
}

TEST(CommandLine, LongAndForeignFileNamesAreFine) {
    const TemporaryFolder folder;
    const std::string triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const std::string& name : {std::string(200, 'x') + ".off", std::string("b\xff\xfe.off")}) {
        write_text(folder / name, triangle);
        const ProgramRun run = run_scb("render levels \"" + (folder / name) +
                                       "\" --size 320x240 -o " + (folder / "out"));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(json::parse(file_text(folder / "out/index.json"))["files"].size(), 1u);
    }
}

TEST(CommandLine, ExportedLevelsCanBeReadBack) {
    const TemporaryFolder folder;
    for (const char* extension : {"ply", "obj", "glb", "stl"})
        for (const char* volume : {"scb", "ball", "obb"}) {
            const std::string file = folder / (std::string("level.") + extension);
            const ProgramRun run = run_scb("export spheres-l1 --level 4 --segments 16 --volume " +
                                           std::string(volume) + " -o " + file);
            ASSERT_EQ(run.status, 0) << run.err;
            const Mesh mesh = scenes::load_mesh(file);
            EXPECT_GE(mesh.triangles.size(), 32u * 12) << file;
            const Box box = bounding_box(mesh);
            EXPECT_GT(box.upper[0] - box.lower[0], 3.5);
            EXPECT_LT(box.upper[0] - box.lower[0], 6);
        }
}

TEST(CommandLine, ExportSaysWhichVolumesHaveNoSurface) {
    const TemporaryFolder folder;
    const std::string segment = "v 0 0 0\nv 10 0 0\nv 5 0 0\nf 1 2 3\n";
    folder.write("segment.obj", segment);
    folder.write("two.obj", segment + "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\n");
    const std::string file = folder / "out.ply";
    for (const char* volume : {"scb2", "obb"}) {
        const auto exported = [&](const char* mesh) {
            return run_scb("export " + (folder / mesh) + " --volume " + volume +
                           " --levels leaves -o " + file);
        };
        const ProgramRun none = exported("segment.obj");
        EXPECT_EQ(none.status, 2);
        EXPECT_NE(none.err.find("points or segments"), std::string::npos) << none.err;
        const ProgramRun one = exported("two.obj");
        EXPECT_EQ(one.status, 0);
        EXPECT_NE(one.err.find("2 volumes, of which 1 without a surface left out"),
                  std::string::npos)
            << one.err;
    }
}

TEST(CommandLine, TwoMeshesAndAPose) {
    const TemporaryFolder folder;
    const std::string file = folder / "body.ply";
    ASSERT_EQ(run_scb("export soup --level 2 --segments 8 -o " + file).status, 0);
    const ProgramRun run =
        run_scb("render levels " + file + " " + file +
                " --pose 1,0,0,5,0,1,0,0,0,0,1,0 --levels 2 --size 320x240 -o " + (folder / "out"));
    EXPECT_EQ(run.status, 0) << run.err;
    const ProgramRun scaled =
        run_scb("stats " + file + " " + file + " --pose 2,0,0,5,0,2,0,0,0,0,2,0");
    EXPECT_EQ(scaled.status, 2);
    EXPECT_NE(scaled.err.find("not rigid"), std::string::npos) << scaled.err;
}

TEST(CommandLine, HelpOfACommandHasTwoSpellings) {
    EXPECT_EQ(run_scb("help").out, run_scb("--help").out);
    EXPECT_EQ(run_scb("help render levels").out, run_scb("render levels --help").out);
    EXPECT_EQ(run_scb("help diff").status, 0);
    EXPECT_EQ(run_scb("help help").out, run_scb("--help").out);
    for (const auto& [words, sentence] : std::vector<std::pair<std::string, std::string>>{
             {"help nope", "unknown command 'nope' of `scb`; give one of "},
             {"help clolide", "unknown command 'clolide' of `scb`, did you mean collide?; give"},
             {"help render level", "'level' of `scb render`, did you mean levels?; give one"},
             {"nope --help", "unknown command 'nope' of `scb`"}}) {
        const ProgramRun run = run_scb(words);
        EXPECT_EQ(run.status, 2) << words;
        EXPECT_EQ(run.out, "");
        EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    }
}

TEST(CommandLine, SuggestsTheNearestWord) {
    for (const auto& [arguments, suggestion] :
         std::initializer_list<std::pair<std::string, std::string>>{
             {"colide spheres-l1", "unknown command 'colide' of `scb`, did you mean collide?"},
             {"render level spheres-l1", "of `scb render`, did you mean levels?"},
             {"collide spheres-l1 --frmaes 0", "of `scb collide`, did you mean --frames?"},
             {"collide spheres-l1 --quite", "of `scb collide`, did you mean --quiet?"},
             {"collide spheres-l1 --volume bal", "'bal' is not a volume, did you mean ball?"},
             {"collide spheres-11", "no such scene or file, did you mean spheres-l1?"}}) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(suggestion), std::string::npos) << run.err;
    }
    for (const std::string arguments :
         {"xyzzy", "collide spheres-l1 --qwertyuiop", "collide spheres-l1 --volume zz"})
        EXPECT_EQ(run_scb(arguments).err.find("did you mean"), std::string::npos) << arguments;
}

TEST(CommandLine, VolumesAndRangesHaveSeveralSpellings) {
    const auto out = [](const std::string& arguments) {
        const ProgramRun run = run_scb("collide spheres-l1 " + arguments);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        return run.out;
    };
    EXPECT_EQ(out("--frames 0-10 --volume OBB"), out("--frames 0:10 --volume obb"));
    for (const std::string frames : {"0-10-2", "10-0", "-5", "0-"})
        EXPECT_EQ(run_scb("collide spheres-l1 --frames=" + frames).status, 2) << frames;
}

}  // namespace
}  // namespace scb::app
