#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/recordings/small_engine.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// Balls with a test that errs in both directions. B moves along x: to 2, to -0.5, to 2.
const char* const balls = R"({"setting": "engine", "value": "tiny"}
{"setting": "results", "value": "pairs"}
{"stage": 1, "name": "balls"}
{"mesh": 0, "name": "m", "coordinate_bytes": 8, "coordinates": [0,0,0, 0.1,0,0, 0,0.1,0, 0,0,0.1], "indices": [0,1,2, 0,1,3]}
{"tree": 0, "name": "a", "of_mesh": 0}
{"node": 10, "in_tree": 0, "parent": null, "children": [11, 12, 13], "volume": ["ball", 0, 0, 0, 2]}
{"node": 11, "in_tree": 0, "parent": 10, "name": "left", "items": [0], "volume": ["ball", -1, 0, 0, 0.5]}
{"node": 12, "in_tree": 0, "parent": 10, "items": [1]}
{"node": 13, "in_tree": 0, "parent": 10, "volume": ["ball", 5, 0, 0, 0.25]}
{"tree": 1, "name": "b", "of_mesh": 0}
{"node": 5, "in_tree": 1, "parent": null, "items": [0, 1], "volume": ["ball", 0, 0, 0, 1]}
{"body": 0, "name": "A", "of_tree": 0}
{"body": 1, "name": "B", "of_tree": 1}
{"frame": 0}
{"pose": 1, "rows": [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 1]}
{"tests": [[0, 10, 5], [0, 11, 5], [1, 13, 5]]}
{"complete": true}
{"frame": 3}
{"pose": 1, "rows": [1, 0, 0, -0.5, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 1]}
{"tests": [[0, 10, 5], [1, 11, 5], [1, 11, 5], [0, 10, 5]]}
{"complete": true}
{"frame": 7}
{"pose": 1, "rows": [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 1]}
{"tests": [[0, 10, 5]]}
{"complete": true}
{"end": true}
)";

struct ExplainRecording : testing::Test {
    TemporaryFolder folder;
    std::string file = folder.write("balls.jsonl", balls);

    ProgramRun run(const std::string& arguments) {
        return run_scb("--quiet explain " + file + " " + arguments);
    }
    json printed(const std::string& arguments, int status) {
        const ProgramRun ran = run(arguments + " --json");
        EXPECT_EQ(ran.status, status) << ran.err;
        const json list = json::parse(ran.out, nullptr, false);
        return list.is_array() && list.size() == 1 ? list[0] : json();
    }
};

void expect_part(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(ExplainRecording, ProvesThatATestLetDisjointVolumesPass) {
    const ProgramRun passed = run("--pair 11,5 --frames 0");
    EXPECT_EQ(passed.status, 0) << passed.err;
    expect_part(passed.out, "balls, tiny, frame 0: A 11, B 5\n");
    expect_part(passed.out,
                "node 11 of A, depth 1, 1 triangle, 'left', ball recorded at frame 0\n");
    expect_part(passed.out, "passed, test 1 of 3, which test 0 of the nodes (10, 5) led to\n");
    expect_part(passed.out, "disjoint: at least 1.5 apart along (1, 0, 0), verified\n");
    expect_part(passed.out, "along it, A ends at -0.5 and B begins at 1\n");
    expect_part(passed.out, "FALSE POSITIVE: the test let disjoint volumes pass\n");
    const json result = printed("--pair 11,5 --frames 0", 0);
    EXPECT_EQ(result["engine"], "tiny");
    EXPECT_EQ(result["tests"][0]["answer"], "false positive");
    EXPECT_EQ(result["tests"][0]["led_by"]["nodes"], json::array({10, 5}));
    EXPECT_EQ(result["exact"], "disjoint");
    EXPECT_EQ(result["certificate"]["end_of_a"], -0.5);
    EXPECT_EQ(result["certificate"]["start_of_b"], 1.0);
    EXPECT_EQ(result["certificate"]["gap"], 1.5);
    EXPECT_EQ(result["b_in_a"]["center"], json::array({2.0, 0.0, 0.0}));
}

// Frame 3, which has the most tests, is the frame where none is named.
TEST_F(ExplainRecording, ProvesThatATestRejectedVolumesThatOverlap) {
    const ProgramRun wrong = run("--pair 11,5");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.err, "scb: the test rejected volumes that overlap.\n");
    expect_part(wrong.out, "frame 3: A 11, B 5\n");
    expect_part(wrong.out, "engine    rejected at balls, test 1 of 4, ");
    expect_part(wrong.out, "again     rejected at balls, test 2 of 4, ");
    expect_part(wrong.out, " is in both, and B is at least 1 deep in A, verified\n");
    expect_part(wrong.out, "FALSE NEGATIVE: the test rejected volumes that overlap\n");
    const json result = printed("--pair 11,5", 1);
    ASSERT_EQ(result["tests"].size(), 2u);
    EXPECT_EQ(result["tests"][0]["stage"], "balls");
    EXPECT_EQ(result["tests"][0]["answer"], "false negative");
    EXPECT_EQ(result["exact"], "overlapping");
}

TEST_F(ExplainRecording, TakesTheFirstFrameThatTestedTheNodes) {
    const json result = printed("--pair 13,5", 0);
    EXPECT_EQ(result["frame"], 0);
    ASSERT_EQ(result["tests"].size(), 1u);
    EXPECT_EQ(result["tests"][0]["stage"], "balls");
    EXPECT_EQ(result["tests"][0]["answer"], "correct");
}

TEST_F(ExplainRecording, ExplainsVolumesThatWereNotTested) {
    const ProgramRun untested = run("--pair 13,5 --frames 7");
    EXPECT_EQ(untested.status, 0) << untested.err;
    expect_part(untested.out, "it recorded no test of these two nodes in this query\n");
    expect_part(untested.out, "disjoint: at least 1.75 apart along (-1, 0, 0), verified\n");
    EXPECT_EQ(untested.out.find("answer"), std::string::npos);
    EXPECT_EQ(printed("--pair 13,5 --frames 7", 0)["tests"], json::array());
}

TEST_F(ExplainRecording, RefusesNodesThatThereAreNot) {
    for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
             {"--pair 9,5", "the tree of A has no node 9; it has 4, with numbers from 10 to 13."},
             {"--pair 10,0", "the tree of B has no node 0; it has 1, with numbers from 5 to 5."},
             {"--pair 12,5", "node 12 of A has no volume in the recording"},
             {"--pair -1,5", "-1 is no number of a node"},
             {"--pair 4294967295,5", "4294967295 is no number of a node"},
             {"--pair 11,5 --frames 0,3", "this command takes one frame"},
             {"--pair 11,5 --frames 4", "has no frame 4"},
             {"--pair 11,5 --bodies B,A", "has no query of these bodies"}}) {
        const ProgramRun refused = run(arguments);
        EXPECT_EQ(refused.status, 2) << arguments;
        EXPECT_EQ(refused.out, "");
        expect_part(refused.err, part);
        EXPECT_EQ(lines(refused.err).size(), 1u);
    }
}

TEST_F(ExplainRecording, WithAVolumeItIsOfOwnHierarchies) {
    const ProgramRun own = run("--pair 0,1 --frames 0 --volume obb");
    EXPECT_EQ(own.status, 0) << own.err;
    expect_part(own.out, "axis-a0");
}

TEST_F(ExplainRecording, DrawsThePair) {
    const std::string out = folder / "out";
    const std::string arguments = " --size 320x240 --samples 1 -o " + out;
    EXPECT_EQ(run("--pair 11,5" + arguments).status, 1);
    EXPECT_EQ(run("--pair 13,5 --frames 7" + arguments).status, 0);
    const json index = json::parse(file_text(out + "/index.json"));
    EXPECT_EQ(index["command"], "explain");
    const std::string name = index["files"][0]["file"];
    EXPECT_TRUE(name.starts_with("balls_tiny_explain_")) << name;
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
    EXPECT_EQ(index["files"][0]["exact"], "disjoint");
    EXPECT_EQ(files_in(out), 3u);
}

// The first that `scb inspect` finds in it.
TEST(ExplainBrokenEngine, ProvesWhatInspectCalledWrong) {
    const TemporaryFolder folder;
    const std::string file = folder / "wrong-radius.scbrec";
    record_small_engine(Bug::wrong_radius, file);
    const ProgramRun run = run_scb("--quiet explain --json --pair 226,248 --frames 0 " + file);
    EXPECT_EQ(run.status, 1);
    const json result = json::parse(run.out)[0];
    ASSERT_EQ(result["tests"].size(), 1u);
    EXPECT_EQ(result["tests"][0]["test"], 136);
    EXPECT_EQ(result["tests"][0]["stage"], "balls");
    EXPECT_EQ(result["tests"][0]["answer"], "false negative");
    EXPECT_EQ(result["certificate"]["verified"], true);
    EXPECT_GE(result["certificate"]["depth"], 0.0597);
    EXPECT_EQ(result["nodes"][0]["volume"], "ball");
}

}  // namespace
}  // namespace scb::app
