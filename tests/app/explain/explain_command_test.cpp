#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// Of the paper's line 8: a large ball about a small one, which has its slab above its center.
const char* const missed_by_line_8 = R"({
  "a": {"center": [0,0,0], "radius": 2, "normal": [0,0,1], "e": 2, "f": -2},
  "b": {"center": [0,0,1], "radius": 0.5, "normal": [0,0,1], "e": 0.5, "f": 0.1}})";

/// Two flat volumes. The second one can be moved and changed.
json pair_of(double height) {
    json pair = json::parse(R"({
      "a": {"center": [0,0,0], "radius": 1, "normal": [0,0,1], "e": 0.25, "f": -0.25},
      "b": {"center": [0,0,0], "radius": 1, "normal": [0,0,1], "e": 0.25, "f": -0.25},
      "pose": [1,0,0,0.1, 0,1,0,0, 0,0,1,0]})");
    pair["pose"][11] = height;
    return pair;
}

struct ExplainCommand : testing::Test {
    TemporaryFolder folder;

    std::string file_of(const json& pairs) { return folder.write("pairs.json", pairs.dump()); }
    json explained(const std::string& arguments, int status = 0) {
        const ProgramRun run = run_scb("--quiet explain --json " + arguments);
        EXPECT_EQ(run.status, status) << arguments << run.err;
        EXPECT_EQ(lines_of(run.err), status == 1 ? 1u : 0u) << run.err;
        const json list = json::parse(run.out, nullptr, false);
        EXPECT_TRUE(list.is_array()) << run.out;
        return list;
    }
};

// Some pairs of every stage that a query ended at, asked by node, of the scene and of the trace.
TEST_F(ExplainCommand, EndsAtTheStageThatTheQuerySawInTheSamePair) {
    const std::string trace = folder / "t.scbrec";
    for (const char* options : {"", "--test printed", "--test extents", "--volume obb"}) {
        const std::string asked = std::string(options) + " ";
        ASSERT_EQ(run_scb("trace spheres-l1 --frames 50 " + asked + "-o " + trace).status, 0);
        const json tests =
            json::parse(run_scb("trace --events --json " + trace).out)["frames"][0]["tests"];
        std::map<std::string, int> tried;
        for (const json& test : tests) {
            const std::string stage = test["stage"];
            if (tried[stage]++ >= 2) continue;
            const std::string pair =
                " --pair " + test["nodes"][0].dump() + "," + test["nodes"][1].dump();
            const std::string scene = tried[stage] == 1 ? trace : "spheres-l1 --frame 50 " + asked;
            const ProgramRun run = run_scb("--quiet explain --json " + scene + pair);
            const json found = json::parse(run.out)[0];
            const std::string test_name = found["test"];
            EXPECT_EQ(found["stage"][test_name], stage) << scene << pair;
            EXPECT_EQ(found["frame"], 50);
            EXPECT_EQ(found["nodes"][0]["depth"], test["depths"][0]);
            EXPECT_EQ(found["nodes"][1]["index"], test["nodes"][1]);
            EXPECT_EQ(run.status, found["answer"] == "false negative" ? 1 : 0);
        }
        EXPECT_GE(tried.size(), 4u) << options;
    }
}

TEST_F(ExplainCommand, TellsWhatThePrintedTestMisses) {
    const std::string file = folder.write("one.json", missed_by_line_8);
    const json printed = explained("--test printed --pairs " + file, 1);
    ASSERT_EQ(printed.size(), 1u);
    EXPECT_EQ(printed[0]["pair"], 0);
    EXPECT_EQ(printed[0]["answer"], "false negative");
    EXPECT_EQ(printed[0]["exact"], "overlapping");
    EXPECT_EQ(printed[0]["stage"], json::parse(R"({"printed": "ball-slab", "line8": "overlapping",
        "corrected": "overlapping", "symmetric": "overlapping", "extents": "overlapping"})"));
    const json corrected = explained("--test corrected --pairs " + file);
    EXPECT_EQ(corrected[0]["answer"], "correct");
    EXPECT_EQ(corrected[0]["answers"]["printed"], "false negative");

    const ProgramRun text = run_scb("explain --test printed --pairs " + file);
    EXPECT_EQ(text.status, 1);
    for (const char* part : {"d1 − f1 < −r1", "rejects; as printed: r1, where it must be r0",
                             "FALSE NEGATIVE", "rejected at ball-slab", "verified"})
        EXPECT_NE(text.out.find(part), std::string::npos) << part << text.out;
    EXPECT_EQ(text.out.find('\033'), std::string::npos);
    EXPECT_NE(run_scb("--color always explain --test printed --pairs " + file).out.find('\033'),
              std::string::npos);
}

TEST_F(ExplainCommand, GivesEveryStepAndTheProof) {
    const json found = explained("--test corrected --pairs " + file_of({pair_of(0.75)}))[0];
    EXPECT_EQ(found["stage"]["corrected"], "slab-cylinder");
    EXPECT_EQ(found["exact"], "disjoint");
    EXPECT_NEAR(found["certificate"]["gap"], 0.25, 1e-9);
    EXPECT_NEAR(found["certificate"]["direction"][2], 1, 1e-9);
    EXPECT_EQ(found["certificate"]["verified"], true);
    EXPECT_EQ(found["b_in_a"]["center"], json({0.1, 0.0, 0.75}));
    EXPECT_EQ(found["pose"].size(), 12u);
    const json steps = found["steps"];
    ASSERT_EQ(steps.size(), 7u);
    EXPECT_EQ(steps[5]["line"], 19);
    EXPECT_EQ(steps[5]["rejects"], true);
    EXPECT_NEAR(steps[5]["slack"], 0.25, 1e-6);
    EXPECT_EQ(steps[6]["reached"], false);
    EXPECT_EQ(steps[6]["separates"], true);
    for (const json& step : steps) EXPECT_TRUE(step["formula"].is_string());

    const json deep = explained("--pairs " + file_of({pair_of(0.25)}))[0];
    EXPECT_EQ(deep["exact"], "overlapping");
    EXPECT_NEAR(deep["certificate"]["depth"], 0.25, 1e-9);
    EXPECT_EQ(deep["certificate"]["point"].size(), 3u);
    const json touching = explained("--pairs " + file_of({pair_of(0.5)}))[0];
    EXPECT_EQ(touching["exact"], "touching");
    EXPECT_TRUE(touching["certificate"].is_null());
    EXPECT_EQ(touching["answer"], "correct");
}

TEST_F(ExplainCommand, SaysWhyCylindersAreNotTried) {
    json pair = pair_of(0.75);
    pair["b"]["normal"] = {0.8, 0, 0.6};
    const json found = explained("--test corrected --pairs " + file_of(pair))[0];
    EXPECT_EQ(found["steps"][5]["not_tried"], "|n0·n1| = 0.6 is not above a = 0.7");
    EXPECT_EQ(found["steps"][5]["reached"], false);
    const json tried = explained("--test corrected --threshold 0.5 --pairs " + file_of(pair))[0];
    EXPECT_FALSE(tried["steps"][5].contains("not_tried"));
}

TEST_F(ExplainCommand, TakesBallsAndBoxes) {
    const json pairs = json::parse(R"([
      {"a": {"center": [0,0,0], "radius": 1}, "b": {"center": [0,0,2.5], "radius": 1}},
      {"a": {"center": [0,0,0], "axes": [[1,0,0],[0,1,0],[0,0,1]], "half": [1,1,1]},
       "b": {"center": [1.5,0,0], "axes": [[0,1,0],[-1,0,0],[0,0,1]], "half": [1,1,0]}}])");
    const json found = explained("--pairs " + file_of(pairs));
    EXPECT_EQ(found[0]["stage"], json({{"ball", "ball-ball"}}));
    EXPECT_EQ(found[0]["exact"], "disjoint");
    EXPECT_EQ(found[1]["stage"], json({{"obb", "overlapping"}}));
    EXPECT_EQ(found[1]["exact"], "overlapping");
    EXPECT_EQ(found[1]["steps"].size(), 15u);
    EXPECT_EQ(explained("--pairs " + file_of(json::array())), json::array());
}

TEST_F(ExplainCommand, DefinesTheSymbolsOfEachTest) {
    const char* const two_slabs = R"({
      "a": {"center": [0,0,0], "radius": 2, "slabs": [{"normal": [0,0,1], "e": 1, "f": -1},
                                                      {"normal": [0,1,0], "e": 1, "f": -1}]},
      "b": {"center": [0,0,1], "radius": 2, "slabs": [{"normal": [0,0,1], "e": 1, "f": -1},
                                                      {"normal": [0,1,0], "e": 1, "f": -1}]}})";
    const std::string file = file_of(json::parse(two_slabs)),
                      two = run_scb("explain --pairs " + file).out,
                      one = run_scb("explain --pairs " + file_of(pair_of(0.4))).out;
    for (const char* symbol : {"sλ: ", "u: ", "w: ", "ρ: ", "″: ", "d: "})
        EXPECT_NE(two.find(symbol), std::string::npos) << symbol << two;
    // Lines are the paper's, which has no such test.
    EXPECT_EQ(two.find("  line  stage"), std::string::npos) << two;
    EXPECT_NE(one.find("  line  stage"), std::string::npos) << one;
}

TEST_F(ExplainCommand, MakesGoodWhatSinglePrecisionLeaves) {
    json pair = pair_of(0.75);
    pair["a"]["normal"] = {0, 0, 1.0000004};
    pair["b"]["e"] = 1.5;
    pair["pose"][0] = 0.9999998;
    const json found = explained("--pairs " + file_of({pair_of(0.75), pair}))[1];
    ASSERT_EQ(found["notes"].size(), 3u);
    EXPECT_EQ(found["notes"][0],
              "[1].a.normal has the length 1.0000004 and was made a unit vector.");
    EXPECT_EQ(found["notes"][1], "[1].b.e = 1.5 is beyond the ball and was made 1.");
    EXPECT_EQ(found["a"]["normal"], json({0.0, 0.0, 1.0}));
    EXPECT_EQ(found["b"]["e"], 1.0);
    EXPECT_EQ(found["pose"][0], 1.0);
}

TEST_F(ExplainCommand, AddsUpManyPairs) {
    json pairs = json::array();
    for (int i = 0; i < 500; ++i) pairs.push_back(pair_of(0.003 * i));
    pairs.push_back(json::parse(missed_by_line_8));
    const std::string file = file_of(pairs);
    const json found = explained("--test printed --pairs " + file, 1);
    ASSERT_EQ(found.size(), 501u);
    std::size_t rejected = 0;
    for (const json& pair : found) rejected += pair["stage"]["printed"] != "overlapping";
    const ProgramRun text = run_scb("explain --test printed --pairs " + file);
    EXPECT_EQ(text.status, 1);
    EXPECT_TRUE(text.out.ends_with("501 pairs: " + std::to_string(rejected) + " rejected, " +
                                   std::to_string(501 - rejected) +
                                   " passed; 0 false positives, 1 false negatives: pair 500\n"))
        << text.out.substr(text.out.size() - 100);
}

TEST_F(ExplainCommand, DrawsAPictureOfEveryPair) {
    const std::string out = folder / "out", small = " --size 320x240 --samples 1 -o " + out;
    const ProgramRun run = run_scb("explain spheres-l1 --frame 50 --pair 412,97" + small);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with("spheres-l1, frame 50: A 412, B 97\n"));
    const std::string name =
        "spheres-l1_scb_explain_samples-1_size-320x240_frame-0050_A-412_B-97.png";
    const std::string picture = file_text(out + "/" + name);
    EXPECT_TRUE(picture.starts_with("\x89PNG"));
    const json index = json::parse(file_text(out + "/index.json"));
    EXPECT_EQ(index["command"], "explain");
    EXPECT_EQ(index["files"][0]["file"], name);
    EXPECT_EQ(index["files"][0]["exact"], "disjoint");
    run_scb("explain spheres-l1 --frame 50 --pair 412,97" + small);
    EXPECT_EQ(file_text(out + "/" + name), picture);

    const std::string file = file_of({pair_of(0.75), json::parse(missed_by_line_8)});
    const json found = explained("--test printed --pairs " + file + small, 1);
    const std::string missed = "pairs_explain_test-printed_samples-1_size-320x240_pair-001.png";
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1]["file"], missed);
    EXPECT_TRUE(file_text(out + "/" + missed).starts_with("\x89PNG"));
    for (const char* camera : {"--camera orbit:30,20", "--ortho", "--up y", "--camera contact"})
        EXPECT_EQ(run_scb("explain --pairs " + file + small + " " + camera).status, 0) << camera;
}

// Volumes that leave little to draw.
TEST_F(ExplainCommand, DrawsWhatHasNoSize) {
    json pairs = json::array();
    for (const double r : {0.0, 1e-60, 1e-9, 1.0, 1e60})
        for (const double far : {0.0, 1e-9, 1.0, 1e9, 1e60}) {
            json pair = pair_of(0);
            pair["b"] = {{"center", {far, 0, far}},
                         {"radius", r},
                         {"normal", {0, 0, 1}},
                         {"e", r / 2},
                         {"f", -r / 2}};
            pairs.push_back(pair);
            pair["a"] = pair["b"];
            pairs.push_back(pair);
        }
    const ProgramRun run = run_scb("explain --pairs " + file_of(pairs) +
                                   " --size 320x240 --samples 1 -o " + (folder / "out"));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(files_in(folder.path / "out"), pairs.size() + 1);
}

TEST_F(ExplainCommand, RefusesVolumesByFieldAndPair) {
    const auto refused = [&](const json& pairs, const std::string& sentence) {
        const ProgramRun run = run_scb("explain --pairs " + file_of(pairs));
        EXPECT_EQ(run.status, 2) << sentence;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find("pairs.json: " + sentence), std::string::npos) << run.err;
    };
    const auto changed = [&](const char* field, const json& value) {
        json pair = pair_of(1);
        pair["b"][field] = value;
        return json({pair_of(1), pair});
    };
    refused(changed("normal", {0, 0, 0}), "[1].b.normal: expected three numbers that are not all");
    refused(changed("normal", {0, 0, 1.1}),
            "[1].b.normal: this is not a unit vector: its length is 1.1");
    refused(changed("normal", {0, nullptr, 1}), "[1].b.normal: expected three numbers, found");
    refused(changed("e", -0.5), "[1].b.e: e = -0.5 is below f = -0.25");
    refused(changed("radius", -1), "[1].b.radius: expected a number from 0");
    refused(changed("radius", nullptr), "[1].b.radius: expected a number, found null");
    refused(changed("size", 1), "[1].b: unknown field \"size\"");
    refused(changed("half", {1, 1, 1}), "[1]: a is a slab cut ball and b is a box");
    json above = pair_of(1);
    above["b"]["e"] = 3;
    above["b"]["f"] = 2;
    refused(above, "b.f: f = 2 is above the ball, whose radius is 1: the volume holds no point");
    above["b"]["e"] = -2;
    above["b"]["f"] = -3;
    refused(above, "b.e: e = -2 is below the ball");
    json pair = pair_of(1);
    pair["b"].erase("f");
    refused(pair, "b: the field \"f\" is missing");
    pair = pair_of(1);
    pair.erase("b");
    refused(pair, "the field \"b\" is missing");
    pair = pair_of(1);
    pair["pose"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
    refused(pair, "pose: the pose is not rigid");
    pair["pose"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    refused(pair, "pose: the pose is not rigid (the matrix mirrors");
    pair["pose"] = {1, 0, 0};
    refused(pair, "pose: expected twelve numbers");
    pair = json::parse(R"({"a": {"center": [0,0,0], "axes": [[1,0,0],[0,1,0],[0,0,1]],
        "half": [1,1,-1]}, "b": {"center": [0,0,0], "axes": [[1,0,0],[0,1,0],[0,0,1]],
        "half": [1,1,1]}})");
    refused(pair, "a.half[2]: expected a number from 0");
    pair["a"]["half"][2] = 1;
    pair["b"]["axes"][0] = {1, 1, 0};
    refused(pair, "b.axes: the axes are not a rotation");
    refused("pairs", "expected a pair of volumes");
    folder.write("pairs.json", "[{\"a\":\n }]");
    const ProgramRun run = run_scb("explain --pairs " + (folder / "pairs.json"));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("line 2, column 2: not valid JSON"), std::string::npos) << run.err;
}

TEST_F(ExplainCommand, RefusesWhatMakesNoSense) {
    const std::string file = file_of(pair_of(1));
    json many = json::array();
    for (int i = 0; i < 1001; ++i) many.push_back(pair_of(1));
    const std::string many_file = folder.write("many.json", many.dump());
    const std::string index_file = folder.write("index.json", pair_of(1).dump());
    const std::size_t files = files_in(folder.path);
    const std::vector<std::pair<std::string, std::string>> refusals = {
        {"", "there is nothing to explain"},
        {"spheres-l1", "Give --pair I,J"},
        {"spheres-l1 --pair 1", "--pair 1: give the numbers of two nodes"},
        {"spheres-l1 --pair 1,x", "--pair 1,x: give the numbers of two nodes"},
        {"spheres-l1 --pair 1,2,3", "--pair 1,2,3: give the numbers of two nodes"},
        {"spheres-l1 --pair -1,2", "there is no node -1 of A"},
        {"spheres-l1 --pair 1,40959",
         "there is no node 40959 of B; its hierarchy has the nodes 0 to 40958"},
        {"spheres-l1 --pair 1,2 --frame 500",
         "--frames 500: there is no frame 500; the scene 'spheres-l1' has the frames 0 to 499"},
        {"spheres-l1 --pair 1,2 --test fast", "'fast' is not an overlap test"},
        {"spheres-l1 --pair 1,2 --test printed,corrected", "one overlap test at a time"},
        {"spheres-l1 --pair 1,2 --volume scb,ball", "takes one of"},
        {"spheres-l1 --pair 1,2 --threshold 2", "--threshold 2"},
        {"spheres-l1 --pair 1,2 --bodies A,C", "'C' is not a body"},
        {"spheres-l1 --pair 1,2 --size 100x100", "--size"},
        {"spheres-l1 --pair 1,2 --background dark", "say where with -o DIR"},
        {"spheres-l1 --pairs " + file, "leave out one of them"},
        {"--pairs " + file + " --frame 3", "--frames: it is of scenes"},
        {"--pairs " + file + " --volume obb", "--volume: it is of scenes"},
        {"--pairs " + index_file + " -o " + folder.path.string(),
         "index.json, which this command reads"},
        {"--pairs none.json", "none.json: there is no such file"},
        {"--pairs " + many_file + " -o " + (folder / "new"), "at most 1000 are drawn"},
        {"cone.off --pair 0,0", "there is no such file"},
    };
    for (const auto& [arguments, sentence] : refusals) {
        const ProgramRun run = run_scb("explain " + arguments);
        EXPECT_EQ(run.status, 2) << arguments << run.err;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << arguments << run.err;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << arguments << run.err;
    }
    EXPECT_EQ(files_in(folder.path), files);
    EXPECT_EQ(run_scb("explain --pairs " + file + " -o /proc/none").status, 3);
}

TEST_F(ExplainCommand, DrawsIntoTheFileThatIsNamed) {
    const std::string file = folder / "new/part.png";
    const ProgramRun run =
        run_scb("explain spheres-l1 --frames 250 --pair 0,0 --json --size 640x480 -o " + file);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)[0]["file"], "part.png");
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_EQ(files_in(folder / "new"), 1u);
}

}  // namespace
}  // namespace scb::app
