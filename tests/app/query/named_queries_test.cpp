#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// Two balls that overlap; the query "lift" rejects them, which is wrong.
const char* const named_queries = R"({"stage": 1, "name": "balls"}
{"tree": 0}
{"node": 0, "in_tree": 0, "items": [0], "volume": ["ball", 0, 0, 0, 1]}
{"tree": 1}
{"node": 0, "in_tree": 1, "items": [0], "volume": ["ball", 0, 0, 0, 1]}
{"body": 0, "name": "arm", "of_tree": 0}
{"body": 1, "name": "shelf", "of_tree": 1}
{"frame": 0}
{"pose": 1, "rows": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0]}
{"log": "gripper closed"}
{"query": [0, 1], "name": "rest"}
{"tests": [[0, 0, 0]]}
{"complete": true}
{"query": [0, 1], "name": "lift", "tags": ["grasp"]}
{"tests": [[1, 0, 0]]}
{"complete": true}
{"end": true}
)";

TEST(NamedQueries, OfBodiesThatCannotBePlacedAreStillJudged) {
    const TemporaryFolder folder;
    std::string text = named_queries;
    text.replace(text.find("1, 0]}") + 3, 1, "1e71");
    const std::string file = folder.write("far.jsonl", text);
    for (const char* bodies : {"", " --bodies arm,shelf"}) {
        const ProgramRun run = run_scb("inspect " + file + bodies);
        EXPECT_EQ(run.status, 4) << run.out << run.err;
        EXPECT_NE(run.out.find("is beyond 1e70"), std::string::npos) << run.out;
    }
}

TEST(NamedQueries, AreSelectedByCommands) {
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", named_queries);
    const ProgramRun all = run_scb("inspect " + file);
    EXPECT_EQ(all.status, 1) << all.out;
    EXPECT_NE(all.out.find("frame 0, arm and shelf (\"lift\"): nodes 0 of A and 0 of B"),
              std::string::npos)
        << all.out;
    EXPECT_NE(all.out.find("Log of frames with errors\n  frame 0: gripper closed\n"),
              std::string::npos)
        << all.out;
    EXPECT_NE(all.err.find(" --query lift --frames 0 --pair 0,0"), std::string::npos) << all.err;
    EXPECT_EQ(run_scb("inspect --query lift " + file).status, 1);
    EXPECT_EQ(run_scb("inspect --tag grasp " + file).status, 1);
    EXPECT_NE(run_scb("inspect --query rest " + file).status, 1);
    // Without a name, commands show the first query of the two bodies in a frame.
    EXPECT_EQ(run_scb("explain --frames 0 --pair 0,0 " + file).status, 0);
    EXPECT_EQ(run_scb("explain --query lift --frames 0 --pair 0,0 " + file).status, 1);
    EXPECT_EQ(run_scb("diff --query rest " + file + " " + file).status, 0);
    const json printed = json::parse(run_scb("trace --json --events --tag grasp " + file).out);
    EXPECT_EQ(printed["frames"][0]["tests"][0]["stage"], "balls") << printed;
    const std::vector<std::pair<std::string, std::string>> refused = {
        {"inspect --query lif " + file, "--query lif: "},
        {"inspect --query rest --tag grasp " + file, "--query rest --tag grasp: "},
        {"inspect --query lift --frames 1 " + file, " with --query lift has no frame 1"},
        {"inspect --bodies arm,arm " + file, "has no query of these bodies"},
        {"inspect --bodies arm,shelve " + file, "--bodies arm,shelve: "},
        {"collide cone --query lift", "--query lift: "},
        {"stats cone --tag grasp", "--tag grasp: "}};
    for (const auto& [command, words] : refused) {
        const ProgramRun run = run_scb(command);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    }
}

/// Two triangles: the query "apart", and, at another pose in the same frame, "through".
const char* const two_poses = R"({"setting": "engine", "value": "E"}
{"mesh": 0, "name": "m", "coordinate_bytes": 8, "coordinates": [0,0,0, 1,0,0, 0,1,0], "indices": [0,1,2]}
{"tree": 0, "of_mesh": 0}
{"node": 0, "in_tree": 0, "items": [0], "volume": ["ball", 0, 0, 0, 1]}
{"body": 0, "name": "arm", "of_tree": 0}
{"body": 1, "name": "shelf", "of_tree": 0}
{"frame": 0}
{"pose": 0, "rows": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]}
{"pose": 1, "rows": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 5]}
{"query": [0, 1], "name": "apart"}
{"tests": [[1, 0, 0]]}
{"complete": true}
{"pose": 1, "rows": [1, 0, 0, 0.25, 0, 0, 1, 0, 0, 1, 0, -0.25]}
{"query": [0, 1], "name": "through"}
{"tests": [[0, 0, 0], ["meet", 0, 0], ["pair", 0, 0]]}
{"complete": true}
{"end": true}
)";

TEST(NamedQueries, OfOneFrameHaveTheirOwnPosesInEveryCommand) {
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", two_poses);
    const auto collide = [&file](const std::string& options) {
        return json::parse(run_scb("collide --json " + options + file).out)["frames"][0];
    };
    const json first = collide(""), through = collide("--query through ");
    EXPECT_EQ(first["pairs"], 0) << first;
    EXPECT_EQ(first["recorded"]["pairs"], 0) << first;
    EXPECT_EQ(through["pairs"], 1) << through;
    EXPECT_EQ(through["recorded"]["pairs"], 1) << through;
    EXPECT_EQ(through["recorded"]["false"], 0) << through;
    // Also in commands that make their own queries of the recorded meshes.
    EXPECT_EQ(collide("--first --query through ")["pairs"], 1);
    EXPECT_EQ(collide("--first --query apart ")["pairs"], 0);
    const std::string own = folder / "own.scbrec", of_own = " --volume scb -o " + own + " " + file;
    EXPECT_EQ(run_scb("trace --query through" + of_own).status, 2) << "the selection would be lost";
    ASSERT_EQ(run_scb("trace --records --query through" + of_own).status, 0);
    EXPECT_EQ(json::parse(run_scb("trace --json " + own).out)["frames"][0]["pairs"], 1);
}

TEST(NamedQueries, AreDrawnAtTheirPosesWithTheirNames) {
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", two_poses), out = folder / "out";
    const auto picture = [&](const std::string& command, const std::string& name) {
        const ProgramRun run = run_scb("render " + command + " --svg -o " + out + " " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name + ".png")) << name << run.out;
        return file_text(out + "/" + name + ".svg");
    };
    const std::string levels = "levels --frames 0 --levels 0 --no-sheet ";
    EXPECT_TRUE(picture(levels + "--query apart", "q_query-apart_E_level-00_frame-0000") !=
                picture(levels + "--query through", "q_query-through_E_level-00_frame-0000"));
    const std::string pairs =
        picture("pairs --query through", "q_query-through_E_pairs_frame-0000");
    EXPECT_NE(pairs.find("through"), std::string::npos) << "the title names the query";
    picture("pairs --volume scb --query through", "q_query-through_scb_pairs_frame-0000");
}

TEST(NamedQueries, ThatAreLeftOutAreNotCompared) {
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", two_poses);
    const ProgramRun diff = run_scb("diff " + file + " " + file);
    EXPECT_EQ(diff.status, 2) << diff.out;
    EXPECT_NE(diff.err.find("--query or --tag"), std::string::npos) << diff.err;
    EXPECT_EQ(run_scb("diff --query apart " + file + " " + file).status, 0);
    EXPECT_EQ(json::parse(run_scb("trace --json " + file).out)["left_out"], 1);
    EXPECT_FALSE(
        json::parse(run_scb("trace --json --query apart " + file).out).contains("left_out"));
}

TEST(NamedQueries, ThatAreLeftOutAreNotGuarded) {
    const TemporaryFolder folder;
    folder.write("q.jsonl", two_poses);
    const auto update = [&folder](const std::string& run, const json& arguments) {
        const json suite = {
            {"scb_golden", 2},
            {"cases",
             {{{"name", "c"}, {"run", run}, {"scene", "q.jsonl"}, {"arguments", arguments}}}}};
        const std::string file = folder.write("cases.json", suite.dump());
        return run_scb("golden update --all --suite " + file + " --baselines " + folder / "b");
    };
    for (const char* of : {"external", "collide"}) {
        const ProgramRun refused = update(of, json::array());
        EXPECT_EQ(refused.status, 1) << of << refused.out << refused.err;
        EXPECT_NE((refused.out + refused.err).find("--query or --tag"), std::string::npos) << of;
        EXPECT_EQ(update(of, {"--query", "through"}).status, 0) << of;
    }
}

TEST(NamedQueries, ThatAreLeftOutAreNoted) {
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", two_poses);
    const std::string note = "1 later query of arm and shelf is left out";
    for (const std::string& command :
         {"collide " + file, "trace " + file, "explain --pair 0,0 " + file,
          "render pairs " + file + " -o " + folder / "p",
          "view " + file + " -o " + folder / "v.html"})
        EXPECT_NE(run_scb(command).err.find(note), std::string::npos) << command;
    EXPECT_EQ(run_scb("collide --query apart " + file).err.find("left out"), std::string::npos);
}

/// The first picture of a problem, as SVG.
std::string problem_svg(const std::string& recording, const std::string& out) {
    const ProgramRun run = run_scb("inspect " + recording + " --svg --no-view -o " + out);
    EXPECT_EQ(run.status, 1) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    for (const json& file : index["files"])
        if (file["svg"].get<std::string>().find("_problem-1-") != std::string::npos)
            return file_text(out + "/" + file["svg"].get<std::string>());
    ADD_FAILURE() << run.out;
    return {};
}

TEST(NamedQueries, AreInTheTitlesOfPicturesOfProblems) {
    const TemporaryFolder folder;
    const std::string named = problem_svg(folder.write("q.jsonl", named_queries), folder / "named");
    EXPECT_NE(named.find("a test that went wrong · "), std::string::npos) << named;
    EXPECT_NE(named.find("lift"), std::string::npos);
    EXPECT_EQ(named.find("arm and shelf"), std::string::npos) << "the only two bodies";

    std::string two(named_queries);
    two.replace(two.find("{\"end\""), std::string::npos, R"({"body": 2, "name": "cup", "of_tree": 1}
{"frame": 1}
{"query": [0, 2]}
{"tests": [[0, 0, 0]]}
{"complete": true}
{"end": true}
)");
    const std::string svg = problem_svg(folder.write("two.jsonl", two), folder / "two");
    EXPECT_NE(svg.find("a test that went wrong · arm and shelf · "), std::string::npos) << svg;
}

}  // namespace
}  // namespace scb::app
