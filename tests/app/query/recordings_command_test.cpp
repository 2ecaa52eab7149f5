#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/png_chunks.h"
#include "tests/recordings/renumbered.h"
#include "tests/recordings/small_engine.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// A scene, and the recording of its queries.
struct RecordingCommands : testing::Test {
    TemporaryFolder folder;
    std::string file = folder / "own.scbrec";

    void record(const std::string& what) {
        const ProgramRun run = run_scb("trace --records " + what + " -o " + file);
        ASSERT_EQ(run.status, 0) << run.err;
    }
    json printed(const std::string& arguments) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 0) << arguments << "\n" << run.err;
        return run.status == 0 ? json::parse(run.out) : json();
    }
    /// Of a diff that finds something.
    json printed_different(const std::string& arguments) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 1) << arguments << "\n" << run.err;
        return run.status == 1 ? json::parse(run.out) : json();
    }
    /// The picture that the command draws, and its entry in the index.
    std::pair<std::string, json> drawn(const std::string& arguments) {
        const std::string out = folder / "out";
        const ProgramRun run =
            run_scb("render " + arguments +
                    " --size 200x150 --samples 1 --no-panel --ids --camera orbit:40,20 -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << "\n" << run.err;
        const json index = json::parse(file_text(out + "/index.json"));
        const json& picture = index["files"].back();
        return {png_without_texts(file_text(out + "/" + picture["ids"].get<std::string>())),
                picture};
    }
};

TEST_F(RecordingCommands, PicturesAreThoseOfOwnQueries) {
    for (const char* volume : {"scb", "scb2", "rss", "aabb"}) {
        const std::string of_volume = std::string(" --volume ") + volume;
        record("cone --frames 100" + of_volume);
        for (const char* picture : {"pairs", "rejections", "rejections --by share",
                                    "pairs --leaves", "pairs --heat wasted"}) {
            const auto [own, own_entry] =
                drawn(std::string(picture) + " cone --frames 100" + of_volume);
            const auto [recorded, entry] = drawn(std::string(picture) + " " + file);
            EXPECT_TRUE(recorded == own) << picture << of_volume;
            EXPECT_EQ(entry["pairs_hash"], own_entry["pairs_hash"]);
            EXPECT_EQ(entry["stages"], own_entry["stages"]) << picture << of_volume;
        }
        const std::string levels = " --levels 5 --no-sheet";
        EXPECT_TRUE(drawn("levels " + file + levels).first ==
                    drawn("levels cone --frames 100" + of_volume + levels).first)
            << volume;
    }
}

TEST_F(RecordingCommands, WithAVolumeItIsAScene) {
    record("cone --frames 60,100 --volume ball");
    const auto own = printed("collide cone --frames 60,100 --volume obb --json"),
               recorded = printed("collide " + file + " --volume obb --json");
    ASSERT_EQ(recorded["frames"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        json frame = recorded["frames"][i];
        EXPECT_EQ(
            frame["recorded"],
            (json{{"pairs", frame["pairs"]}, {"missed", 0}, {"false", 0}, {"within_rounding", 0}}));
        frame.erase("recorded");
        EXPECT_EQ(frame, own["frames"][i]);
    }
    EXPECT_TRUE(drawn("rejections " + file + " --frames 100 --volume obb").first ==
                drawn("rejections cone --frames 100 --volume obb").first);
    EXPECT_EQ(run_scb("export " + file + " --volume obb --levels 3 -o " + folder / "a.ply").status,
              0);
    EXPECT_EQ(
        run_scb("export cone --frames 60 --volume obb --levels 3 -o " + folder / "b.ply").status,
        0);
    EXPECT_TRUE(file_text(folder / "a.ply") == file_text(folder / "b.ply"));
}

TEST_F(RecordingCommands, CollideCountsWhatTheEngineMissed) {
    record("line-8 --frames 40 --test printed");
    const json frame = printed("collide " + file + " --json")["frames"][0];
    EXPECT_EQ(frame["recorded"],
              (json{{"pairs", 0}, {"missed", 30}, {"false", 0}, {"within_rounding", 0}}));
    const ProgramRun table = run_scb("collide " + file);
    EXPECT_NE(table.out.find("        0       30        0\n"), std::string::npos) << table.out;
    EXPECT_NE(run_scb("collide --csv " + file).out.find(",0,30,0\n"), std::string::npos);
    // Of pairs that are cut nothing is counted.
    EXPECT_FALSE(printed("collide --first " + file + " --json")["frames"][0].contains("recorded"));
}

TEST_F(RecordingCommands, TraceAndDiffReadIt) {
    record("cone --frames 60,100 --volume obb");
    const std::string trace = folder / "trace.scbrec";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb -o " + trace).status, 0);
    const json of_trace = printed("trace --json --events " + trace),
               of_recording = printed("trace --json --events " + file);
    ASSERT_EQ(of_recording["frames"].size(), 2u);
    EXPECT_EQ(of_trace["volume"], "obb");
    EXPECT_TRUE(of_trace.contains("version"));
    EXPECT_FALSE(of_recording.contains("version")) << "it is no trace of this program's";
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(of_recording["frames"][i]["tests"], of_trace["frames"][i]["tests"]);
        EXPECT_EQ(of_recording["frames"][i]["stages"], of_trace["frames"][i]["stages"]);
    }
    // Neither a file's name nor how many frames it has makes its trees others.
    const std::string copy = folder / "copy.scbrec";
    std::filesystem::copy_file(file, copy);
    EXPECT_EQ(run_scb("diff " + file + " " + copy).status, 0);
    record("cone --frames 100 --volume obb");
    const ProgramRun fewer = run_scb("diff --json " + file + " " + copy);
    EXPECT_EQ(fewer.status, 1);
    EXPECT_TRUE(json::parse(fewer.out)["nodes_comparable"]);
    EXPECT_TRUE(json::parse(fewer.out)["frames"].empty());
    EXPECT_NE(run_scb("diff " + file + " " + copy).out.find("\naxis-a0 "), std::string::npos);
    std::filesystem::copy_file(copy, file, std::filesystem::copy_options::overwrite_existing);
    const ProgramRun apart = run_scb("diff --json " + file + " " + trace);
    EXPECT_EQ(apart.status, 1);
    const json differences = json::parse(apart.out);
    EXPECT_EQ(differences["pairs_only_in_a"], 0);
    EXPECT_EQ(differences["pairs_only_in_b"], 0);
    EXPECT_EQ(differences["nodes_comparable"], false);
    const std::string text = run_scb("diff " + file + " " + trace).out;
    EXPECT_NE(text.find("\n\nBoth found the same pairs.\n\nasked "), std::string::npos) << text;
    EXPECT_NE(text.find("\n2 frames in both, with equal poses and counts\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("\nNot compared: trees and tests, since only one of the two has its "),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("tree of A"), std::string::npos) << text;
    EXPECT_EQ(text.find("The trees differ"), std::string::npos) << text;
    // Of other volumes the tests are others.
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume scb2 -o " + trace).status, 0);
    EXPECT_NE(run_scb("diff " + file + " " + trace)
                  .out.find("\n2 frames in both, 2 differ otherwise (frames 60, 100)\n"),
              std::string::npos);
}

TEST_F(RecordingCommands, DiffSaysFirstWhichPairsWereMissed) {
    record("line-8 --frames 40 --test printed");
    const std::string trace = folder / "trace.scbrec";
    ASSERT_EQ(run_scb("trace line-8 --frames 40 -o " + trace).status, 0);
    const ProgramRun run = run_scb("diff " + file + " " + trace);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("\n\n0 pairs only in the first, 30 pairs only in the second.\n\nasked "),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("\n1 frame in both, 1 differs (frame 40)\n"), std::string::npos);
    EXPECT_NE(run.out.find("; 5 of them:\n  frame 40, the triangles "), std::string::npos);
}

TEST_F(RecordingCommands, WhatIsAboutOwnHierarchiesAsksForTheirVolume) {
    record("cone --frames 100 --volume obb");
    const std::string out = " -o " + folder / "trace.scbrec";
    EXPECT_EQ(run_scb("trace " + file + out).status, 2);
    EXPECT_EQ(run_scb("trace " + file + " --volume obb" + out).status, 0);
    EXPECT_EQ(run_scb("explain " + file + " --volume obb --pair 0,0").status, 0);
}

TEST_F(RecordingCommands, OfOneThatBreaksOffWhatStandsBeforeIsJudged) {
    record("cone --frames 60,100 --volume obb");
    const ProgramRun whole = run_scb("inspect " + file);
    EXPECT_EQ(whole.status, 0);
    EXPECT_TRUE(whole.out.starts_with("Valid.\n")) << whole.out;
    const std::string bytes = file_text(file);
    for (const double part : {0.3, 0.6, 0.9}) {
        folder.write(
            "cut.scbrec",
            bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
        const ProgramRun cut = run_scb("inspect " + folder / "cut.scbrec");
        EXPECT_EQ(cut.out.find("Wrong"), std::string::npos) << cut.out;
        // A file that breaks off before its first tree has nothing to judge.
        EXPECT_EQ(cut.status, part < 0.8 ? 2 : 4);
    }
    folder.write("empty.scbrec", bytes.substr(0, 12));
    EXPECT_EQ(run_scb("inspect " + folder / "empty.scbrec").status, 2);
}

TEST_F(RecordingCommands, ItStandsBesideOwnQueries) {
    record("cone --frames 100 --volume obb");
    const std::string out = folder / "out";
    const ProgramRun run =
        run_scb("render rejections " + file + " --compare recorded,scb2 --size 640x360 -o " + out);
    EXPECT_EQ(run.status, 0) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    const json& queries = index["files"][0]["queries"];
    EXPECT_EQ(queries[0]["pairs_hash"], queries[1]["pairs_hash"]);
    EXPECT_NE(queries[0]["n_v"], queries[1]["n_v"]);
    EXPECT_EQ(run_scb("render pairs " + file + " --compare ball,recorded --size 640x360 -o " + out)
                  .status,
              0);
    for (const char* wrong : {"recorded", "recorded,recorded", "recorded,cube"})
        EXPECT_EQ(
            run_scb("render rejections " + file + " --compare " + wrong + " -o " + out).status, 2)
            << wrong;
}

TEST_F(RecordingCommands, GoldenCasesOfItAndOfACommandThatMakesIt) {
    record("cone --frames 100 --volume obb");
    folder.write("golden.json", R"({"scb_golden": 2, "cases": [
        {"name": "kept", "run": "external", "scene": "own.scbrec"},
        {"name": "made", "run": "external", "command": ["cp", "own.scbrec", "{}"]},
        {"name": "drawn", "run": "rejections", "frames": "100",
         "command": ["cp", "own.scbrec", "{}"]}]})");
    const std::string suite = " --suite " + folder / "golden.json";
    const ProgramRun update = run_scb("golden update --all" + suite);
    EXPECT_EQ(update.status, 0) << update.out << update.err;
    const ProgramRun same = run_scb("golden check" + suite);
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    record("cone --frames 100 --volume scb2");
    const ProgramRun other = run_scb("golden check" + suite);
    EXPECT_EQ(other.status, 1);
    EXPECT_NE(other.out.find("3 different"), std::string::npos) << other.out;
    EXPECT_NE(other.out.find("cp own.scbrec made.scbrec"), std::string::npos) << other.out;
    for (const char* wrong :
         {R"("command": ["true", "{}"])", R"("command": ["false", "{}"])", R"("command": ["true"])",
          R"("command": ["true", "{}"], "scene": "a")"}) {
        folder.write("golden.json",
                     R"({"scb_golden": 2, "cases": [{"name": "x", "run": "external", )" +
                         std::string(wrong) + "}]}");
        EXPECT_NE(run_scb("golden check" + suite).status, 0) << wrong;
    }
}

/// A recording, and the same of an engine that numbers its nodes otherwise.
struct OwnNumbers : RecordingCommands {
    std::string other = folder / "other.scbrec";

    void record_both(const std::string& what) {
        record(what);
        folder.write("other.scbrec", renumbered(file_text(file)));
    }
    /// The own numbers of a pair of nodes in the other's.
    static json numbers_of(const json& nodes) {
        return {renumbered(0, nodes[0]), renumbered(1, nodes[1])};
    }
    static std::string text_of(const json& nodes) {
        const json numbers = numbers_of(nodes);
        return numbers[0].dump() + "," + numbers[1].dump();
    }
};

TEST_F(OwnNumbers, EventsHaveThem) {
    record_both("cone --frames 60,100 --volume obb");
    const json own = printed("trace --json --events " + file),
               told = printed("trace --json --events " + other);
    std::string text;
    for (std::size_t f = 0; f < 2; ++f) {
        const json &tests = told["frames"][f]["tests"], &of_own = own["frames"][f]["tests"];
        ASSERT_EQ(tests.size(), of_own.size());
        for (std::size_t i = 0; i < tests.size(); ++i) {
            json test = of_own[i];
            test["nodes"] = numbers_of(test["nodes"]);
            if (test.contains("parent"))
                test["parent"]["nodes"] = numbers_of(test["parent"]["nodes"]);
            ASSERT_EQ(tests[i], test) << i;
        }
        const json& nodes = tests[tests.size() / 2]["nodes"];
        text = " " + nodes[0].dump() + " " + nodes[1].dump() + " ";
    }
    const ProgramRun run = run_scb("trace --events --frames 100 " + other);
    EXPECT_NE(run.out.find(text), std::string::npos) << text;
    const std::string head = "   test  parent     node A     node B  depths  outcome\n";
    EXPECT_NE(run.out.find(head + "      0       -     100000 3000000009   0   0  "),
              std::string::npos);
}

TEST_F(OwnNumbers, AreThoseThatInspectNames) {
    const std::string engine = folder / "engine.scbrec";
    for (const Bug bug : {Bug::axis_flipped, Bug::early_exit}) {
        record_small_engine(bug, engine);
        folder.write("other.scbrec", renumbered(file_text(engine)));
        const ProgramRun inspected = run_scb("inspect --json " + other);
        EXPECT_EQ(inspected.status, 1);
        const json judged = json::parse(inspected.out),
                   events = printed("trace --json --events " + other);
        std::size_t seen = 0;
        for (const json& group : judged["missed"])
            for (const json& one : group["cases"]) {
                if (!one.contains("test")) continue;
                const json& test = events["frames"][one["frame"].get<std::size_t>()]["tests"]
                                         [one["test"].get<std::size_t>()];
                EXPECT_EQ(one["nodes"], test["nodes"]) << one;
                ++seen;
            }
        EXPECT_GT(seen, 0u);
    }
}

TEST_F(OwnNumbers, DiffHasThoseOfEachSide) {
    const std::string corrected = folder / "corrected.scbrec",
                      bracket = SCB_SOURCE_DIR "/scenes/samples/bracket.json --frames 85 --test ";
    record(bracket + "corrected");
    std::filesystem::copy_file(file, corrected);
    record_both(bracket + "printed");
    const json own = printed_different("diff --json " + corrected + " " + file),
               told = printed_different("diff --json " + corrected + " " + other);
    ASSERT_TRUE(told["nodes_comparable"]);
    EXPECT_EQ(told["first"]["a"], own["first"]["a"]);
    EXPECT_EQ(told["first"]["b"]["nodes"], numbers_of(own["first"]["b"]["nodes"]));
    EXPECT_EQ(told["first"]["b"]["parent"]["nodes"],
              numbers_of(own["first"]["b"]["parent"]["nodes"]));
    ASSERT_EQ(told["lost"].size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(told["lost"][i]["pair"], own["lost"][i]["pair"]) << "of triangles";
        EXPECT_EQ(told["lost"][i]["lost_at"]["nodes"],
                  numbers_of(own["lost"][i]["lost_at"]["nodes"]));
    }
    const std::string text = run_scb("diff " + corrected + " " + other).out;
    const auto nodes = [](const json& pair) {
        return "the nodes (" + pair[0].dump() + ", " + pair[1].dump() + ")";
    };
    EXPECT_NE(text.find("first tested " + nodes(own["first"]["a"]["nodes"])), std::string::npos);
    EXPECT_NE(text.find("second tested " + nodes(told["first"]["b"]["nodes"])), std::string::npos)
        << text;
}

TEST_F(OwnNumbers, RootsOfATraversalAreGivenByThem) {
    record_both("cone --frames 100 --volume obb");
    const auto drawn = [this](const std::string& arguments) {
        const std::string out = folder / "out";
        const ProgramRun run =
            run_scb("render traversal " + arguments + " --size 640x480 -o " + out);
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(file_text(out + "/index.json"));
    };
    const json own = drawn(file)["files"][0]["parts"], told = drawn(other)["files"][0]["parts"];
    ASSERT_GE(own.size(), 4u);
    ASSERT_EQ(told.size(), own.size());
    std::string root, of_own;
    for (const auto& [nodes, tests] : own.items()) {
        of_own = nodes;
        root = text_of(json::parse("[" + nodes + "]"));
        EXPECT_EQ(told[root], tests) << nodes;
    }
    const json part = drawn(other + " --root " + root);
    EXPECT_EQ(part["options"]["root"], json::parse("[" + root + "]"));
    EXPECT_EQ(part["files"][0]["n_v"], own[of_own]);
    const ProgramRun none =
        run_scb("render traversal " + other + " --root " + of_own + " -o " + folder / "none");
    EXPECT_EQ(none.status, 2);
    const std::string largest = std::max_element(told.begin(), told.end()).key();
    EXPECT_NE(none.err.find("has no test of these nodes; try " + largest), std::string::npos)
        << none.err;
}

TEST_F(OwnNumbers, PicturesNameTheirNodesByThem) {
    record_both("cone --frames 100 --volume obb");
    const std::string out = folder / "out";
    const auto picked = [&](const std::string& source) {
        const ProgramRun run = run_scb(
            "render rejections " + source +
            " --focus 1 --size 640x480 --no-panel --usual-direction --pick 320,240 -o " + out);
        EXPECT_EQ(run.status, 0) << run.err;
        const std::size_t at = run.out.find("node ");
        return at == std::string::npos ? "" : run.out.substr(at, run.out.find(" of ", at) - at);
    };
    const std::string own = picked(file), told = picked(other);
    ASSERT_EQ(own.find("node "), 0u);
    const auto node = static_cast<std::uint32_t>(std::stoul(own.substr(5)));
    EXPECT_TRUE(told == "node " + std::to_string(renumbered(0, node)) ||
                told == "node " + std::to_string(renumbered(1, node)))
        << own << ", " << told;
    // What the ids of pixels stand for.
    const std::string look = " --size 160x120 --no-panel --ids -o " + out;
    ASSERT_EQ(run_scb("render levels " + other + " --levels 3" + look).status, 0);
    const json levels = json::parse(file_text(out + "/index.json"))["files"][0]["bodies"];
    ASSERT_EQ(run_scb("render pairs " + other + look).status, 0);
    const json pairs = json::parse(file_text(out + "/index.json"))["files"][0]["node_numbers"];
    for (const std::uint32_t side : {0u, 1u})
        for (const json& numbers : {levels[side]["node_numbers"], pairs[side]}) {
            ASSERT_GT(numbers.size(), 12u);
            EXPECT_EQ(numbers[12], renumbered(side, 12));
        }
    ASSERT_EQ(run_scb("render pairs " + file + look).status, 0);
    EXPECT_FALSE(json::parse(file_text(out + "/index.json"))["files"][0].contains("node_numbers"));
}

TEST_F(OwnNumbers, ThePageListsThem) {
    record_both("cone --frames 100 --volume obb");
    const std::string page = folder / "page.html";
    const auto manifest = [&](const std::string& source) {
        EXPECT_EQ(run_scb("view " + source + " -o " + page).status, 0);
        const std::string text = file_text(page), before = "id=\"manifest\">";
        const std::size_t at = text.find(before) + before.size();
        return json::parse(text.substr(at, text.find("</script>", at) - at));
    };
    const json own = manifest(file), told = manifest(other);
    std::size_t listed = 0;
    const json &worst = own["columns"][0]["query"]["worst"],
               &of_other = told["columns"][0]["query"]["worst"];
    for (std::size_t i = 0; i < worst.size(); ++i)
        for (std::size_t k = 0; k < worst[i].size(); ++k, ++listed)
            EXPECT_EQ(of_other[i][k]["nodes"], numbers_of(worst[i][k]["nodes"]));
    EXPECT_GT(listed, 4u);
    for (const char* block : {"numbers", "names"}) {
        EXPECT_TRUE(told["trees"][0].contains(block));
        EXPECT_FALSE(own["trees"][0].contains(block));
    }
}

}  // namespace
}  // namespace scb::app
