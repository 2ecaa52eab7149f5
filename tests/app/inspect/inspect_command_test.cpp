#include <gtest/gtest.h>
#include <sys/stat.h>

#include <set>
#include <string>

#include "tests/app/inspect/inspect_run.h"

namespace scb::app {
namespace {

using nlohmann::json;

TEST(InspectCommand, AddsUpToWhatCollideCounts) {
    for (const char* options : {"", "--volume obb", "--volume ball",
                                "--test extents --descent area", "--max-pairs 5", "--level 6"}) {
        const std::string arguments = "spheres-l1 --frames 0,60,250 " + std::string(options);
        const json found = inspect(arguments),
                   live = json::parse(run_scb("collide --json " + arguments).out);
        ASSERT_EQ(found["frames"].size(), 3u);
        std::uint64_t previous = UINT64_MAX, wasted = 0;
        for (const json& frame : found["frames"]) {
            json counts;
            for (const json& other : live["frames"])
                if (other["frame"] == frame["frame"]) counts = other;
            for (const char* key : {"pairs", "n_v", "n_p"}) EXPECT_EQ(frame[key], counts[key]);
            EXPECT_EQ(frame["passed"], counts["stages"]["overlapping"]) << options;
            EXPECT_EQ(frame["passed"],
                      count(frame, "test") + count(frame, "fit") + count(frame, "true"));
            EXPECT_EQ(frame["work"]["n_v"], frame["n_v"]);
            const std::uint64_t here = frame["wasted"]["n_v"];
            EXPECT_EQ(here, frame["wasted_by"]["test"]["n_v"].get<std::uint64_t>() +
                                frame["wasted_by"]["fit"]["n_v"].get<std::uint64_t>());
            EXPECT_LE(here, previous) << "the worst frame comes first";
            previous = here;
            wasted += here;
        }
        EXPECT_EQ(found["sum"]["wasted"]["n_v"], wasted);
        std::uint64_t tests = 0;
        for (const json& depth : found["depths"]) tests += depth["n_v"].get<std::uint64_t>();
        EXPECT_EQ(found["sum"]["n_v"], tests);
    }
}

TEST(InspectCommand, NamesTheSceneOfATraceInItsCommand) {
    const TemporaryFolder folder;
    const std::string trace = folder / "cone.scbrec";
    ASSERT_EQ(run_scb("trace cone --frames 80 -o " + trace).status, 0);
    const std::string command = inspect(trace)["settings"]["command"];
    EXPECT_TRUE(command.starts_with("scb collide cone")) << command;
    const std::string mesh = folder / "level.ply";
    ASSERT_EQ(run_scb("export spheres-l1 --levels 3 -o " + mesh).status, 0);
    ASSERT_EQ(
        run_scb("trace " + mesh + " " + mesh + " --pose=1,0,0,0.25,0,1,0,0,0,0,1,0 -o " + trace)
            .status,
        0);
    const json found = inspect(trace);
    const std::string with_pose = found["settings"]["command"];
    EXPECT_NE(with_pose.find("--pose=1,0,0,0.25,0,1,0,0,0,0,1,0"), std::string::npos) << with_pose;
    EXPECT_EQ(
        json::parse(run_scb(with_pose.substr(4) + " --json").out)["mean"]["n_v"],
        found["settings"]["settings"][found["settings"]["best"]["cost"].get<std::size_t>()]["n_v"]);
}

TEST(InspectCommand, SaysTheSameOfATrace) {
    const TemporaryFolder folder;
    const std::string trace = folder / "t.scbrec";
    for (const char* arguments :
         {"spheres-l1 --frames 60,100 --test corrected --threshold 0.8",
          "spheres-l1 --frames 60 --max-pairs 3", "knots-l1 --frames 7 --volume obb --level 4"}) {
        ASSERT_EQ(run_scb("trace " + std::string(arguments) + " -o " + trace).status, 0);
        EXPECT_EQ(run_scb("inspect " + trace + " --frames all").out,
                  run_scb("inspect " + std::string(arguments)).out);
    }
}

/// The pairs of nodes in a list, with the tests below them.
json listed(const json& pairs) {
    json list = json::array();
    for (const json& pair : pairs)
        list.push_back({pair["frame"], pair["nodes"], pair["depths"], pair["reason"], pair["exact"],
                        pair["wasted"]["n_v"], pair["wasted"]["n_p"]});
    return list;
}

TEST(InspectCommand, FindsTheSameWasteInARecordingOfTheSameQueries) {
    const TemporaryFolder folder;
    const std::string recording = folder / "r.scbrec";
    for (const char* arguments :
         {"spheres-l1 --frames 60,100", "knots-l1 --frames 7 --volume obb",
          "long-triangles --frames 0,120 --test corrected --descent area"}) {
        ASSERT_EQ(run_scb("trace --records " + std::string(arguments) + " -o " + recording).status,
                  0);
        const json own = inspect(arguments), recorded = inspect(recording),
                   waste = recorded["waste"];
        EXPECT_FALSE(recorded["wrong"].get<bool>());
        EXPECT_EQ(recorded["not_judged"].size(), 0u);
        for (const char* key : {"pairs", "n_v", "n_p", "passed", "inner", "leaves",
                                "wrongly_rejected", "missed_pairs"})
            EXPECT_EQ(waste["sum"][key], own["sum"][key]) << arguments << " " << key;
        EXPECT_EQ(waste["depths"], own["depths"]) << arguments;
        EXPECT_EQ(listed(waste["worst"]), listed(own["worst"])) << arguments;
        EXPECT_FALSE(waste["sum"]["wasted"].contains("operations"))
            << "the operations of another engine are unknown";
        for (std::size_t i = 0; i < own["worst"].size(); ++i) {
            const char* key = own["worst"][i]["exact"] == "disjoint" ? "gap" : "depth";
            EXPECT_NEAR(waste["worst"][i][key], own["worst"][i][key], 1e-6) << arguments;
        }
    }
}

TEST(InspectCommand, HasNoWasteOfARecordingThatIsWrong) {
    const TemporaryFolder folder;
    const std::string recording = folder / "r.scbrec";
    ASSERT_EQ(
        run_scb("trace --records spheres-l1 --frames 60 --test printed -o " + recording).status, 0);
    const json found = inspect(recording, 1);
    EXPECT_TRUE(found["wrong"].get<bool>());
    EXPECT_FALSE(found.contains("waste"));
}

TEST(InspectCommand, TheWorstPairsAreFalse) {
    const json found = inspect("spheres-l1 --frame 60 --top 3");
    ASSERT_EQ(found["worst"].size(), 6u);
    const json collisions = json::parse(run_scb("collide --json spheres-l1 --frames 60").out);
    for (const json& pair : found["worst"]) {
        EXPECT_EQ(pair["frame"], 60);
        EXPECT_GT(pair["wasted"]["n_v"].get<int>() + pair["wasted"]["n_p"].get<int>(), 0);
        EXPECT_EQ(pair["exact"] == "disjoint", pair["reason"] == "test");
        EXPECT_GT(pair[pair["reason"] == "test" ? "gap" : "depth"].get<double>(), 0);
    }
    for (const std::size_t i : {0u, 1u, 3u, 4u})
        EXPECT_GE(found["worst"][i]["wasted"]["n_v"].get<int>() +
                      found["worst"][i]["wasted"]["n_p"].get<int>(),
                  found["worst"][i + 1]["wasted"]["n_v"].get<int>() +
                      found["worst"][i + 1]["wasted"]["n_p"].get<int>());
    // The wasted work of the worst pair is no more than the frame's.
    EXPECT_LT(found["worst"][0]["wasted"]["n_v"], collisions["frames"][0]["n_v"]);
}

TEST(InspectCommand, PrintedRejectsWronglyAndNoOtherTestDoes) {
    const ProgramRun run = run_scb("inspect spheres-l1 --frame 60 --test printed");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("pairs of volumes that meet"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("REJECTED WRONGLY"), std::string::npos);
    for (const char* test : {"line8", "corrected", "symmetric", "extents"})
        EXPECT_EQ(
            inspect("spheres-l1 --frame 60 --test " + std::string(test))["sum"]["wrongly_rejected"],
            0);
    const json wrong = inspect("spheres-l1 --frame 60 --test printed", 1);
    EXPECT_GT(wrong["sum"]["wrongly_rejected"], 0);
    EXPECT_EQ(wrong["worst_rejections"].size(), 10u);
    // What printed lost counts as contact nevertheless.
    EXPECT_EQ(inspect("spheres-l1 --frame 60")["worst"][0]["nodes"], wrong["worst"][0]["nodes"]);
}

TEST(InspectCommand, OtherTestsAreWholeQueries) {
    const json found = inspect("spheres-l1 --frames 60,100");
    ASSERT_EQ(found["other_tests"].size(), 4u);
    for (const json& other : found["other_tests"]) {
        std::string arguments =
            "collide --json spheres-l1 --frames 60,100 --test " + other["test"].get<std::string>();
        if (other.contains("threshold")) arguments += " --threshold " + other["threshold"].dump();
        std::uint64_t n_v = 0, n_p = 0, pairs = 0;
        const json live = json::parse(run_scb(arguments).out);
        for (const json& frame : live["frames"]) {
            n_v += frame["n_v"].get<std::uint64_t>();
            n_p += frame["n_p"].get<std::uint64_t>();
            pairs += frame["pairs"].get<std::uint64_t>();
        }
        EXPECT_EQ(other["n_v"], n_v) << arguments;
        EXPECT_EQ(other["n_p"], n_p) << arguments;
        EXPECT_EQ(other["pairs"], pairs) << arguments;
    }
    EXPECT_EQ(inspect("spheres-l1 --frame 60 --volume obb")["other_tests"].size(), 0u);
}

TEST(InspectCommand, ReplacesNothingThatTheSceneWasReadFrom) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", scene = R"({"scb_scene": 1,
        "name": "linked", "frames": 1, "models": [{"name": "m", "file": "m.obj"}],
        "bodies": [{"name": "A", "model": "m"}, {"name": "B", "model": "m"}]})";
    write_text(folder / "m.obj", mesh);
    write_text(folder / "linked.json", scene);
    ASSERT_EQ(run_scb("trace " + folder / "linked.json -o " + folder / "t.scbrec").status, 0);
    for (const auto& [link, target] : {std::pair<std::string, std::string>{
                                           "linked_scb_inspect_size-320x240_frames.csv", "m.obj"},
                                       {"linked_scb_inspect_size-320x240.html", "linked.json"},
                                       {"linked_scb_inspect_size-320x240.png", "m.obj"},
                                       {"index.json", "t.scbrec"}})
        for (const char* source : {"linked.json", "t.scbrec"}) {
            const fs::path out = folder.path / "out";
            fs::remove_all(out);
            fs::create_directory(out);
            fs::create_symlink("../" + target, out / link);
            const std::string before = file_text(folder / target);
            const ProgramRun run =
                run_scb("inspect " + folder / source + " --size 320x240 -o " + out.string());
            EXPECT_EQ(file_text(folder / target), before) << link << " " << source;
            if (target != "t.scbrec" || source == target) {
                EXPECT_EQ(run.status, 2) << link << " " << source;
            }
        }
    // What is not a file is not written to either.
    const fs::path out = folder.path / "out";
    fs::remove_all(out);
    fs::create_directory(out);
    ASSERT_EQ(::mkfifo((out / "linked_scb_inspect_size-320x240_pairs.csv").c_str(), 0600), 0);
    const ProgramRun run =
        run_scb("inspect " + folder / "linked.json --size 320x240 -o " + out.string());
    EXPECT_EQ(run.status, 3) << run.err;
}

TEST(InspectCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    const std::string trace = folder / "t.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 60 -o " + trace).status, 0);
    for (const auto& [arguments, said] :
         {std::pair<std::string, std::string>{"spheres-l1 --top 0", "1 to 10000"},
          {"spheres-l1 --top 201 -o " + folder / "out", "1 to 200"},
          {"spheres-l1 --size 640x480", "-o DIR"},
          {"spheres-l1 --size 64x48 -o " + folder / "out", "--size"},
          {"spheres-l1 --frame 500", "0 to 499"},
          {"spheres-l1 --frame -1", "0 to 499"},
          {"spheres-l1 --frame 1 --frames 2", "--frame"},
          {"spheres-l1 --volume scb,ball", "one"},
          {trace + " --test extents", "is recorded"},
          {trace + " --frame 61", "60"}}) {
        const ProgramRun run = run_scb("inspect " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_NE(run.err.find(said), std::string::npos) << arguments << ": " << run.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

/// A recording of two balls that overlap, with a query of these tests.
std::string recording_of_balls(const TemporaryFolder& folder, const std::string& tests) {
    std::string text;
    for (const std::string body : {"0", "1"})
        text += R"({"tree": )" + body + R"(, "of_mesh": null}
{"node": 0, "in_tree": )" +
                body +
                R"(, "parent": null, "items": [0], "volume": ["ball", 0, 0, 0, 1]}
{"body": )" + body +
                R"(, "of_tree": )" + body + R"(, "name": "body )" + body + "\"}\n";
    return folder.write("balls.jsonl", text + R"({"frame": 0}
{"query": [0, 1]}
{"tests": )" + tests + R"(}
{"complete": true}
{"end": true}
)");
}

TEST(InspectCommand, SuggestsToExplainOnlyNodesThatExist) {
    const TemporaryFolder folder;
    const ProgramRun unknown = run_scb("inspect " + recording_of_balls(folder, "[[0, 7, 0]]"));
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.out.find("a test of a node that its tree does not have"), std::string::npos)
        << unknown.out;
    EXPECT_EQ(unknown.err.find("scb explain"), std::string::npos) << unknown.err;

    const std::string file = recording_of_balls(folder, "[[0, 7, 0], [1, 0, 0]]");
    const ProgramRun both = run_scb("inspect " + file);
    EXPECT_EQ(both.status, 1);
    EXPECT_NE(
        both.err.find("`scb explain " + file + " --frames 0 --pair 0,0` explains a test at fault"),
        std::string::npos)
        << both.err;
    EXPECT_EQ(run_scb("explain " + file + " --frames 0 --pair 0,0").status, 1);
}

TEST(InspectCommand, JudgesARecording) {
    const TemporaryFolder folder;
    const std::string file = folder / "q.scbrec";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb --records -o " + file).status, 0);
    const ProgramRun valid = run_scb("inspect " + file);
    EXPECT_EQ(valid.status, 0) << valid.err;
    EXPECT_TRUE(valid.out.starts_with("Valid.\n")) << valid.out;
    EXPECT_NE(valid.out.find(": valid"), std::string::npos) << valid.out;
    EXPECT_NE(valid.out.find(" 0 missed, 0 false"), std::string::npos) << valid.out;
    EXPECT_EQ(nlohmann::json::parse(run_scb("inspect --json " + file).out)["verdict"], "valid");

    ASSERT_EQ(run_scb("trace line-8 --frames 40 --test printed --records -o " + file).status, 0);
    const ProgramRun wrong = run_scb("inspect --json " + file);
    EXPECT_EQ(wrong.status, 1) << wrong.err;
    const auto judged = nlohmann::json::parse(wrong.out);
    EXPECT_EQ(judged["wrong"], true);
    ASSERT_EQ(judged["missed"].size(), 1u);
    EXPECT_EQ(judged["missed"][0]["what"], "rejected although the volumes overlap");
    EXPECT_EQ(judged["missed"][0]["cases"][0]["nodes"], nlohmann::json({0, 0}));

    const std::string bytes = file_text(file);
    folder.write("cut.scbrec", bytes.substr(0, bytes.size() - 5));
    const ProgramRun cut = run_scb("inspect " + folder / "cut.scbrec");
    EXPECT_EQ(cut.status, 2);
    EXPECT_NE(cut.err.find("cut.scbrec"), std::string::npos) << cut.err;
    const ProgramRun no_frame = run_scb("inspect " + file + " --frames 7");
    EXPECT_EQ(no_frame.status, 2);
    EXPECT_EQ(no_frame.out, "");

    // With options of hierarchies, the recorded meshes and poses are a scene.
    const ProgramRun own = run_scb("inspect --json --volume obb " + file);
    EXPECT_EQ(own.status, 0) << own.err;
    EXPECT_EQ(nlohmann::json::parse(own.out)["frames"],
              nlohmann::json::parse(
                  run_scb("inspect --json --volume obb --frames 40 line-8").out)["frames"]);
}

TEST(InspectCommand, DrawsWhatWentWrongInARecording) {
    const TemporaryFolder folder;
    const std::string file = folder / "q.scbrec", out = folder / "out";
    ASSERT_EQ(run_scb("trace line-8 --frames 40 --test printed --records -o " + file).status, 0);
    const ProgramRun run = run_scb("inspect " + file + " --size 320x240 -o " + out);
    EXPECT_EQ(run.status, 1) << run.err;
    const auto index = nlohmann::json::parse(file_text(out + "/index.json"));
    ASSERT_EQ(index["files"].size(), 2u);
    for (const auto& picture : index["files"])
        EXPECT_NE(run.out.find(picture["file"].get<std::string>()), std::string::npos);
    EXPECT_EQ(index["files"][1]["what"], "rejected although the volumes overlap");
}

TEST(InspectCommand, TellsWhatWouldHaveHelpedARecording) {
    const TemporaryFolder folder;
    const std::string file = folder / "q.scbrec";
    ASSERT_EQ(run_scb("trace cone --frames 100 --volume obb --records -o " + file).status, 0);
    const auto judged = nlohmann::json::parse(run_scb("inspect --json " + file).out);
    const auto& settings = judged["settings"];
    // One setting of each volume that is not given up.
    std::set<std::string> volumes;
    for (const auto& setting : settings["settings"]) volumes.insert(setting["volume"]);
    EXPECT_EQ(settings["settings"].size(), volumes.size());
    EXPECT_GT(volumes.size(), 2u);
    EXPECT_GT(settings["given_up"], 0);
    EXPECT_EQ(settings["frames"], nlohmann::json({100}));
    // The command gives the counts of the first row.
    const std::string command = settings["command"];
    const auto counts = nlohmann::json::parse(run_scb(command.substr(4) + " --json").out);
    EXPECT_EQ(counts["frames"][0]["n_v"], settings["settings"][0]["n_v"]);
    EXPECT_EQ(counts["frames"][0]["recorded"],
              (nlohmann::json{{"pairs", counts["frames"][0]["pairs"]},
                              {"missed", 0},
                              {"false", 0},
                              {"within_rounding", 0}}));
}

}  // namespace
}  // namespace scb::app
