#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"
#include "tests/scenes/recordings/recording_block.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Traces of one scene that differ in the overlap test.
struct TraceCommand : testing::Test {
    TemporaryFolder folder;
    std::string corrected = folder / "corrected.scbrec", printed = folder / "printed.scbrec";

    std::string record(const std::string& arguments, const std::string& file) {
        const ProgramRun run = run_scb("trace spheres-l1 " + arguments + " -o " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.out, "");
        return file;
    }
    void record_both() {
        record("--frames 0:20:5,200 --test corrected", corrected);
        record("--frames 0:20:5,200 --test printed", printed);
    }
};

TEST_F(TraceCommand, TheSameBytesTwice) {
    const std::string frames = "--frames 100,250 --volume obb";
    record(frames, folder / "a");
    record(frames, folder / "b");
    EXPECT_GT(file_text(folder / "a").size(), 1000u);
    EXPECT_EQ(file_text(folder / "a"), file_text(folder / "b"));
}

TEST_F(TraceCommand, PrintsTheCountsThatCollideDoes) {
    for (const char* options : {"--test corrected", "--volume ball --level 4", "--volume obb",
                                "--max-pairs 3", "--split cost"}) {
        const std::string arguments = std::string(options) + " --frames 100,200,250";
        const std::string file = record(arguments, folder / "t");
        const json trace = json::parse(run_scb("trace " + file + " --json").out);
        const json live = json::parse(run_scb("collide spheres-l1 --json " + arguments).out);
        EXPECT_EQ(trace["frames"], live["frames"]) << options;
        for (const char* key : {"version", "scene", "volume", "test", "threshold", "descent",
                                "growth", "margin", "split", "level"})
            EXPECT_EQ(trace.value(key, json()), live.value(key, json())) << options << key;
    }
}

TEST_F(TraceCommand, PrintsEveryTest) {
    const std::string file = record("--frames 100,250", folder / "t.scbrec");
    const json trace = json::parse(run_scb("trace " + file + " --json --events").out);
    ASSERT_EQ(trace["frames"].size(), 2u);
    for (const json& frame : trace["frames"]) {
        EXPECT_EQ(frame["tests"].size(), frame["n_v"]);
        EXPECT_EQ(frame["tests"][0]["nodes"], json({0, 0}));
        std::size_t triangles = 0, meet = 0;
        for (const json& test : frame["tests"]) {
            triangles += test.contains("triangles");
            meet += test.value("intersect", false);
        }
        EXPECT_EQ(triangles, frame["n_p"]);
        EXPECT_EQ(meet, frame["pairs"]);
    }
    const ProgramRun text = run_scb("trace " + file + " --events --frames 250");
    EXPECT_EQ(text.status, 0);
    const std::size_t header = lines_of(run_scb("trace " + file + " --frames 250").out);
    const auto n_v = trace["frames"][1]["n_v"].get<std::size_t>();
    EXPECT_EQ(lines_of(text.out), header + 2 + n_v);
    EXPECT_NE(text.out.find("rejected at slab-cylinder"), std::string::npos);
}

TEST_F(TraceCommand, RecordsPackedQueriesThatAreValid) {
    for (const char* options : {"--volume scb2 --split cost --layout quantized8",
                                "--layout float2 --leaf 1", "--layout indexed4"}) {
        SCOPED_TRACE(options);
        const std::string arguments = std::string(options) + " --frames 100,250";
        const std::string file = record(arguments, folder / "t.scbrec");
        const json live = json::parse(run_scb("collide spheres-l1 --json " + arguments).out);
        const json trace = json::parse(run_scb("trace " + file + " --json --events").out);
        std::uint64_t tests = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            for (const char* count : {"pairs", "n_v", "n_p"})
                EXPECT_EQ(trace["frames"][i][count], live["frames"][i][count]) << count;
            tests += live["frames"][i]["n_v"].get<std::uint64_t>();
        }
        EXPECT_GT(live["frames"][0]["pairs"], 0);
        const ProgramRun judged = run_scb("inspect " + file + " --json --no-advice");
        EXPECT_EQ(judged.status, 0);
        const json report = json::parse(judged.out);
        EXPECT_EQ(report["verdict"], "valid");
        std::uint64_t judged_tests = 0;
        for (const json& frame : report["frames"])
            judged_tests += frame["volume_tests"].get<std::uint64_t>();
        EXPECT_EQ(judged_tests, tests);
        // The same queries in memory.
        const ProgramRun direct = run_scb("inspect spheres-l1 --json --no-advice " + arguments);
        EXPECT_EQ(direct.status, 0) << direct.err;
        json same = json::parse(direct.out);
        same["recording"] = report["recording"];
        EXPECT_TRUE(same == report);
    }
}

TEST_F(TraceCommand, ALayoutRefusesOptionsOfTheReference) {
    for (const char* options :
         {"--layout quantized8 --test printed", "--layout quantized8 --volume obb",
          "--layout quantized8 --descent area", "--layout quantized9", "--layout float2,float4",
          "--layout quantized8 --bodies A,A", "--layout quantized8 --leaf 5"}) {
        for (const char* command : {"inspect", "trace"}) {
            const ProgramRun run = run_scb(std::string(command) + " spheres-l1 " + options +
                                           " --frames 250 -o " + (folder / "out.scbrec"));
            EXPECT_EQ(run.status, 2) << options;
            EXPECT_NE(run.err.find("--l"), std::string::npos) << run.err;
        }
    }
    EXPECT_FALSE(fs::exists(folder / "out.scbrec"));
}

TEST_F(TraceCommand, AdviceForALayoutIsACommandForTheSameQueries) {
    const std::string arguments = " " SCB_SOURCE_DIR "/scenes/samples/bracket.ply " SCB_SOURCE_DIR
                                  "/scenes/samples/pin.obj --pose 1,0,0,0,0,1,0,-20,0,0,1,30";
    const json report = json::parse(
        run_scb("inspect" + arguments + " --layout quantized4 --bodies B,A --json").out);
    const std::string command = report["settings"]["command"];
    EXPECT_NE(command.find("--pose 1,0,0,0,0,1,0,-20,0,0,1,30"), std::string::npos) << command;
    const json advised = json::parse(run_scb(command.substr(4) + " --json").out);
    EXPECT_GT(advised["frames"][0]["pairs"], 0);
    EXPECT_EQ(advised["frames"][0]["pairs"], report["frames"][0]["pairs"]);
}

TEST_F(TraceCommand, ALayoutIsNotIgnored) {
    const std::string file = record("--frames 100", folder / "t.scbrec"), page = folder / "v.html";
    const std::vector<std::string> commands = {
        "trace " + file + " --layout float2",
        "trace " + file + " --leaf 2",
        "view spheres-l1 --layout float2 --compare corrected,printed -o " + page,
        "view spheres-l1 --layout float2 --queries 0,10 -o " + page,
        "inspect spheres-l1 --layout float2 --top 0",
        "inspect spheres-l1 --layout float2 --shard 1/2 -o " + (folder / "out")};
    for (const std::string& command : commands) {
        const ProgramRun run = run_scb(command);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_NE(run.err.find("--"), std::string::npos) << run.err;
    }
    EXPECT_FALSE(fs::exists(page));
}

TEST_F(TraceCommand, DiffNamesTheTestAtWhichCorrectedAndPrintedPart) {
    record_both();
    const ProgramRun text = run_scb("diff " + corrected + " " + printed);
    EXPECT_EQ(text.status, 1);
    EXPECT_EQ(text.err, "");
    const ProgramRun run = run_scb("diff --json " + corrected + " " + printed);
    EXPECT_EQ(run.status, 1);
    const json d = json::parse(run.out);
    EXPECT_EQ(d["equal"], false);
    EXPECT_EQ(d["asked"], json::parse(R"([{"field":"test","a":"corrected","b":"printed"}])"));
    EXPECT_EQ(d["common_frames"], 6);
    const json first = d["first"];
    EXPECT_EQ(first["a"]["nodes"], first["b"]["nodes"]);
    EXPECT_NE(first["a"]["stage"], first["b"]["stage"]);
    std::ostringstream place;
    place << "They part first at frame " << first["frame"] << ", test " << first["test"];
    EXPECT_NE(text.out.find(place.str()), std::string::npos) << text.out;
    for (const char* side : {"a", "b"})
        EXPECT_NE(text.out.find(first[side]["outcome"].get<std::string>()), std::string::npos);

    // The test is where the traces themselves say so.
    const auto tests = [&](const std::string& file) {
        return json::parse(
            run_scb("trace --json --events --frames " + first["frame"].dump() + " " + file)
                .out)["frames"][0]["tests"];
    };
    const json a = tests(corrected), b = tests(printed);
    const auto at = first["test"].get<std::size_t>();
    for (std::size_t i = 0; i < at; ++i) {
        EXPECT_EQ(a[i]["nodes"], b[i]["nodes"]);
        EXPECT_EQ(a[i]["stage"], b[i]["stage"]);
    }
    const auto without_numbers = [](json test) {
        test.erase("test");
        test.erase("parent_test");
        return test;
    };
    EXPECT_EQ(a[at]["test"], at);
    EXPECT_EQ(a[a[at]["parent_test"].get<std::size_t>()]["nodes"], a[at]["parent"]["nodes"]);
    EXPECT_EQ(without_numbers(a[at]), first["a"]);
    EXPECT_EQ(without_numbers(b[at]), first["b"]);
    // And so is where the other test lost pairs.
    const std::size_t lost = d["pairs_only_in_a"];
    EXPECT_GT(lost, 0u);
    EXPECT_EQ(d["pairs_only_in_b"], 0);
    EXPECT_EQ(d["sum"]["pairs"]["a"].get<std::size_t>() - lost, d["sum"]["pairs"]["b"]);
    EXPECT_EQ(d["lost"].size(), std::min<std::size_t>(lost, 5));
    EXPECT_EQ(d["lost"][0]["lost_at"]["stage"], "ball-slab");
    // The sums are collide's.
    const json live =
        json::parse(run_scb("collide spheres-l1 --json --test printed --frames 0:20:5,200").out);
    std::size_t n_v = 0;
    for (const json& frame : live["frames"]) n_v += frame["n_v"].get<std::size_t>();
    EXPECT_EQ(d["sum"]["n_v"]["b"], n_v);
}

TEST_F(TraceCommand, DiffOfTwoSlabsNamesWhatWasAskedAndItsStagesInOrder) {
    const std::string a = record("--volume scb2 --frames 200", folder / "a"),
                      b = record("--volume scb2 --frames 200 --growth radius --margin 0.2",
                                 folder / "b");
    const std::string text = run_scb("diff " + a + " " + b).out;
    std::size_t at = 0;
    for (const char* part :
         {"growth", "ritter", "radius", "margin", "0.2", "ball-ball", "slab-a", "second-slab-a",
          "slab-b", "second-slab-b", "center-line", "long-axes"}) {
        at = text.find(part, at);
        ASSERT_NE(at, std::string::npos) << part << text;
    }
}

TEST_F(TraceCommand, OfAnotherSplitIsReplayedAndItsNodesAreNotCompared) {
    record("--frames 250", folder / "paper");
    record("--frames 250 --split cost", folder / "cost");
    const ProgramRun diff = run_scb("diff " + (folder / "paper") + " " + (folder / "cost"));
    EXPECT_EQ(diff.status, 1);
    EXPECT_NE(diff.out.find("split"), std::string::npos) << diff.out;
    EXPECT_NE(diff.out.find("tests cannot be compared"), std::string::npos) << diff.out;
    EXPECT_EQ(diff.out.find("part first"), std::string::npos) << diff.out;

    // The verdict on the trace needs its hierarchies, built in the same way.
    const ProgramRun of_trace = run_scb("inspect " + (folder / "cost") + " --json"),
                     of_scene = run_scb("inspect spheres-l1 --frames 250 --split cost --json");
    EXPECT_EQ(of_trace.status, of_scene.status) << of_trace.err;
    EXPECT_EQ(json::parse(of_trace.out)["frames"], json::parse(of_scene.out)["frames"]);
    EXPECT_EQ(run_scb("inspect " + (folder / "cost") + " --split paper").status, 2);
}

TEST_F(TraceCommand, DiffOfEqualTracesAndOfOtherFrames) {
    record("--frames 0:20:5", folder / "a");
    record("--frames 0:20:5", folder / "b");
    record("--frames 10:25:5", folder / "c");
    const ProgramRun equal = run_scb("diff " + (folder / "a") + " " + (folder / "b"));
    EXPECT_EQ(equal.status, 0);
    EXPECT_NE(equal.out.find("equal: 5 frames"), std::string::npos) << equal.out;
    const ProgramRun run = run_scb("diff " + (folder / "a") + " " + (folder / "c"));
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(
        run.out.find(
            "2 frames only in the first (frames 0, 5)\n1 frame only in the second (frame 25)\n"
            "3 frames in both"),
        std::string::npos)
        << run.out;
}

TEST_F(TraceCommand, BadInputIsOneSentenceAndStatus2) {
    record("--frames 0:20:5", corrected);
    const std::string bytes = file_text(corrected);
    write_text(folder / "cut.scbrec", bytes.substr(0, bytes.size() / 2));
    write_text(folder / "text.scbrec", "not a trace");
    std::string flipped = bytes;
    flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
    write_text(folder / "damaged", flipped);
    std::string newer = bytes;
    newer[8] = 2;
    write_text(folder / "newer", newer);
    write_text(folder / "log", "0 0 0 0 0 0 1\n");
    write_text(folder / "one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const std::size_t files = files_in(folder.path);
    const std::string out = " -o " + (folder / "new");
    const std::vector<std::pair<std::string, std::string>> refusals = {
        {"trace " + (folder / "cut.scbrec"), "cut.scbrec is truncated"},
        {"trace " + (folder / "text.scbrec"), "text.scbrec is no recording"},
        {"trace " + (folder / "damaged"), "checksum"},
        {"trace " + (folder / "newer"),
         "is a recording of version 2; this scb reads versions up to 1"},
        {"trace " + (folder / "none.scbrec"), "there is no such file"},
        {"trace " + corrected + out, "is a trace already"},
        {"trace " + corrected + " --records", "is recorded already"},
        {"trace spheres-l1 -o " + (folder / "new.scbtrace"), "name a file .scbrec"},
        {"render levels " + corrected + " -o " + (folder / "out"), "this is a trace"},
        {"convert " + corrected + " -o " + (folder / "new.jsonl"), "scb trace --records"},
        {"trace " + corrected + " --frames 7", "has no frame 7"},
        {"trace " + corrected + " --frames all,7", "has no frame 7"},
        {"trace " + corrected + " --test printed", "--test"},
        {"trace " + corrected + " --level 3", "--levels"},
        {"trace none", "there is no such scene or file"},
        {"trace spheres-l1 -o ''", "the value is empty"},
        {"trace spheres-l1 -o -", "standard output"},
        {"trace spheres-l1 --max-pairs 010" + out, "--max-pairs: '010'"},
        {"trace spheres-l1 --max-pairs 99999999999999999999" + out, "--max-pairs"},
        {"trace spheres-l1 --level ''" + out, "--levels: the value is empty"},
        {"trace spheres-l1 --threshold 0x1p-1 --test corrected" + out, "--threshold: '0x1p-1'"},
        {"trace " + (folder / "one.off") + " " + (folder / "one.off") + " --poses " +
             (folder / "log") + " -o " + (folder / "log"),
         "which this command reads"},
        {"trace spheres-l1 -o " + (folder / "t.png"), "a trace is a .scbrec file; name it so."},
        {"trace spheres-l1 --records -o " + (folder / "t.jsonl"), "a trace is a .scbrec file"},
        {"collide " + corrected, "this is a trace"},
        {"trace spheres-l1", "-o FILE"},
        {"trace spheres-l1 --events" + out, "--events"},
        {"trace spheres-l1 --frames 500" + out, "frames 0 to 499"},
        {"trace spheres-l1 --level 99" + out, "--levels 99"},
        {"trace spheres-l1 --max-pairs 0" + out, "--max-pairs 0"},
        {"trace spheres-l1 --test fast" + out, "'fast' is not an overlap test"},
        {"trace " + (folder / "one.off") + out, "one body"},
        {"diff " + corrected, "B"},
        {"diff " + corrected + " " + (folder / "cut.scbrec"), "cut.scbrec is truncated"},
        {"diff " + (folder / "damaged") + " " + corrected, "checksum"},
        {"diff spheres-l1 " + corrected, "spheres-l1: there is no such file"},
    };
    for (const auto& [arguments, sentence] : refusals) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 2) << arguments << run.err;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << arguments << run.err;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << arguments << run.err;
    }
    EXPECT_EQ(files_in(folder.path), files);
}

TEST_F(TraceCommand, DiffKnowsTheVolumesOfItsOwnRecords) {
    for (const char* volume : {"scb", "obb", "ball"}) {
        const std::string query = std::string("trace cone --frames 80 --volume ") + volume + " -o ";
        ASSERT_EQ(run_scb(query + (folder / "t.scbrec")).status, 0);
        ASSERT_EQ(run_scb(query + (folder / "r.scbrec") + " --records").status, 0);
        const ProgramRun run =
            run_scb("diff " + (folder / "t.scbrec") + " " + (folder / "r.scbrec"));
        EXPECT_EQ(run.out.find("volume "), std::string::npos) << run.out;
    }
}

TEST_F(TraceCommand, RecordsOfABodyAgainstItselfHaveOneBody) {
    const std::string file = folder / "self.scbrec";
    for (const char* volume : {"scb", "obb"}) {
        SCOPED_TRACE(volume);
        const std::string query =
            std::string("soup --frames 0 --bodies A,A --volume ") + volume + " ";
        ASSERT_EQ(run_scb("trace " + query + "--records -o " + file).status, 0);
        const ProgramRun run = run_scb("inspect " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_TRUE(run.out.starts_with("Valid.\n")) << run.out;
        const json recorded = json::parse(run_scb("trace --json " + file).out)["frames"][0],
                   own = json::parse(run_scb("collide --json " + query).out)["frames"][0];
        for (const char* key : {"pairs", "pairs_hash", "n_v", "n_p", "depth", "stages"})
            EXPECT_EQ(recorded[key], own[key]) << key;
    }
}

TEST_F(TraceCommand, OfFilesThatAreGoneNamesItselfAndThem) {
    write_text(folder / "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write_text(folder / "b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0 1\n3 0 1 2\n");
    const std::string trace = folder / "two.scbrec";
    ASSERT_EQ(
        run_scb("trace " + (folder / "a.off") + " " + (folder / "b.off") + " -o " + trace).status,
        0);
    EXPECT_EQ(run_scb("inspect " + trace).status, 0);
    fs::remove(folder / "b.off");
    const ProgramRun run = run_scb("inspect " + trace);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "scb: error: " + trace +
                           ": the query that it recorded cannot be opened from here: " +
                           (folder / "b.off") + ": there is no such file; check the path.\n");
    write_text(folder / "b.off", "OFF\n3 1 0\n");
    EXPECT_NE(
        run_scb("inspect " + trace).err.find("`scb stats " + (folder / "b.off") + "` says why"),
        std::string::npos);
}

// A trace of unknown origin may name any file of its reader.
TEST_F(TraceCommand, TellsNothingOfWhatUnrelatedFilesHold) {
    const std::string scene = folder / "scene.json", mesh = folder / "mesh.ply";
    write_text(scene, R"({"scb_scene": 1, "name": "s", "frames": 1,
        "models": [{"name": "m", "box": {}}], "bodies": [{"name": "A", "model": "m"},
        {"name": "B", "model": "m", "position": [0.5, 0, 0]}]})");
    write_text(mesh,
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const std::string of_scene_trace = folder / "s.scbrec", of_mesh_trace = folder / "m.scbrec";
    ASSERT_EQ(run_scb("trace " + scene + " -o " + of_scene_trace).status, 0);
    ASSERT_EQ(run_scb("trace " + mesh + " " + mesh + " -o " + of_mesh_trace).status, 0);
    const auto tells_nothing = [](const std::string& trace, const std::string& what) {
        const ProgramRun run = run_scb("inspect " + trace);
        EXPECT_EQ(run.status, 2) << what << run.err;
        EXPECT_EQ(run.err.find("secret"), std::string::npos) << what << run.err;
        EXPECT_TRUE(run.err.find("` says why.") != std::string::npos ||
                    run.err.find("record it again, or, where it is a baseline") !=
                        std::string::npos)
            << what << run.err;
    };
    for (const char* text : {"secret", "\"secret", R"({"secret": 1})", R"({"scb_scene": "secret"})",
                             R"({"scb_scene": 1, "name": "x", "models": [{"name": "m", "box": {}}],
              "bodies": [{"name": "secret", "model": "m"}, {"name": "B", "model": "m"}]})"}) {
        write_text(scene, text);
        tells_nothing(of_scene_trace, text);
    }
    for (const char* text : {"secret\n", "ply\nsecret 1 2\n", "ply\nformat secret 1.0\n",
                             "ply\nformat ascii 1.0\nelement vertex 3\nproperty secret x\n"}) {
        write_text(mesh, text);
        tells_nothing(of_mesh_trace, text);
    }
}

TEST_F(TraceCommand, WhatCannotBeWrittenIsStatus3AndLeavesNothing) {
    const ProgramRun nowhere = run_scb("trace spheres-l1 --frames 0 -o /proc/none/t");
    EXPECT_EQ(nowhere.status, 3) << nowhere.err;
    const ProgramRun full =
        run_scb_process("trace spheres-l1 --frames 100:120 -o " + (folder / "t"), "ulimit -f 8;");
    EXPECT_EQ(full.status, 3) << full.err;
    EXPECT_EQ(files_in(folder.path), 0u);
}

TEST_F(TraceCommand, AnInterruptLeavesTheFinishedFrames) {
    const std::string scene = folder / "endless.json", file = folder / "t";
    write_text(scene, endless_scene);
    const ProgramRun run = run_scb_interrupted("trace " + scene + " -o " + file, has_computed);
    ASSERT_EQ(run.status, 130) << run.err;
    ASSERT_NE(run.err.find("interrupted"), std::string::npos);
    EXPECT_EQ(files_in(folder.path), 2u);
    const ProgramRun printed_run = run_scb("trace --json " + file);
    ASSERT_EQ(printed_run.status, 0) << printed_run.err;
    const json trace = json::parse(printed_run.out);
    EXPECT_GT(trace["frames"].size(), 0u);
    EXPECT_LT(trace["frames"].size(), 1'000'000u);
}

// Bodies' names come from outside.
TEST_F(TraceCommand, PrintsNoControlCharacters) {
    const std::string scene = folder / "red.json";
    std::string text = endless_scene;
    text.replace(text.find("\"left\""), 6,
                 "\"l\xc3\xa9"
                 "ft\"");
    write_text(scene, text);
    ASSERT_EQ(run_scb("trace " + scene + " --frames 0 -o " + corrected).status, 0);
    std::string bytes = file_text(corrected);
    const std::size_t at = bytes.find(
        "l\xc3\xa9"
        "ft");
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 5, "l\033[31");
    const std::vector<std::uint8_t> resealed =
        scenes::with_fitting_checksums({bytes.begin(), bytes.end()});
    bytes.assign(resealed.begin(), resealed.end());
    write_text(corrected, bytes);
    ASSERT_EQ(run_scb("trace " + scene + " --frames 0 --level 0 -o " + printed).status, 0);
    for (const std::string& arguments :
         {"trace " + corrected, "trace --events " + corrected, "diff " + corrected + " " + printed,
          "diff " + printed + " " + corrected}) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_LT(run.status, 2) << run.err;
        EXPECT_EQ(run.out.find('\033'), std::string::npos) << arguments;
        EXPECT_NE(run.out.find("l?[31"), std::string::npos) << arguments << run.out;
    }
}

TEST_F(TraceCommand, DiffTellsOtherPairsFromOtherCounts) {
    const std::string a = folder / "a.scbrec", b = folder / "b.scbrec";
    for (const auto& [file, test] : {std::pair(a, "corrected"), std::pair(b, "printed")})
        run_scb("trace spheres-l1 --frames 0:499:50 --test " + std::string(test) + " -o " + file);
    const std::string text = run_scb("diff --top 2 " + a + " " + b).out;
    EXPECT_NE(
        text.find("10 frames in both, 9 differ (frames 50, 100, ...)\n"
                  "7 frames with other pairs (frames 50, 100, ...)\n"
                  "2 frames with the same pairs, but other counts or tests (frames 200, 250)\n"),
        std::string::npos)
        << text;
    const json all = json::parse(run_scb("diff --json " + a + " " + b).out);
    std::size_t other = 0;
    for (const json& frame : all["frames"])
        other += frame["pairs_only_in_a"] != 0 || frame["pairs_only_in_b"] != 0;
    EXPECT_EQ(other, 7u);
    EXPECT_EQ(run_scb("diff --top 0 " + a + " " + b).status, 2);
}

}  // namespace
}  // namespace scb::app
