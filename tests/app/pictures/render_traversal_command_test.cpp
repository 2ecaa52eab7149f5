#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct RenderTraversal : testing::Test {
    TemporaryFolder folder;

    void draw(const std::string& arguments, const std::string& into) {
        const ProgramRun run =
            run_scb("render traversal " + arguments + " --size 640x480 -o " + (folder / into));
        ASSERT_EQ(run.status, 0) << run.err;
    }
    std::string file(const std::string& in, const std::string& name) {
        return file_text(std::filesystem::path(folder / in) / name);
    }
};

TEST_F(RenderTraversal, TheSameFromASceneAndFromATrace) {
    const std::string options = " --frames 0,100,250 --volume obb";
    const std::string trace = folder / "t.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1" + options + " -o " + trace).status, 0);
    for (const auto& [how, in_name] :
         {std::pair{std::string(), std::string()},
          {" --by share --show matrix --background dark", "_by-share_show-matrix"}}) {
        draw("spheres-l1" + options + how, "live");
        draw(trace + " --frames all" + how, "traced");
        for (const char* frame : {"0000", "0100", "0250"}) {
            const std::string name = "spheres-l1_obb_traversal" + in_name + "_size-640x480" +
                                     (how.empty() ? "" : "_background-dark") + "_frame-" + frame +
                                     ".png";
            EXPECT_GT(file("live", name).size(), 1000u) << name;
            EXPECT_EQ(png_without_texts(file("live", name)),
                      png_without_texts(file("traced", name)))
                << name;
        }
    }
}

TEST_F(RenderTraversal, IndexHasTheCountsOfCollide) {
    for (const std::string options :
         {"", " --volume ball --level 4", " --test corrected --max-pairs 3"}) {
        const std::string arguments = "spheres-l1 --frames 0,100,250" + options;
        draw(arguments + " --by share", "out");
        const json index = json::parse(file("out", "index.json"));
        const json live = json::parse(run_scb("collide --json " + arguments).out);
        EXPECT_EQ(index["command"], "render traversal");
        EXPECT_EQ(index["options"]["by"], "share");
        EXPECT_EQ(index["options"]["show"], "both");
        // There is no view of the bodies.
        EXPECT_FALSE(index.contains("camera"));
        EXPECT_FALSE(index.contains("ids"));
        EXPECT_FALSE(index["options"].contains("samples"));
        ASSERT_EQ(index["files"].size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            json counts = index["files"][i];
            EXPECT_FALSE(file("out", counts["file"]).empty());
            counts.erase("file");
            counts.erase("parts");
            EXPECT_EQ(counts, live["frames"][i]) << options;
        }
    }
}

TEST_F(RenderTraversal, APartIsBelowTheTestOfTwoNodes) {
    const std::string scene = "spheres-l1 --frames 100";
    draw(scene, "whole");
    const json whole = json::parse(file("whole", "index.json"))["files"][0];
    ASSERT_GE(whole["parts"].size(), 4u);
    const auto largest = std::max_element(whole["parts"].begin(), whole["parts"].end());
    const std::string root = largest.key();
    draw(scene + " --root " + root, "part");
    const json index = json::parse(file("part", "index.json")), part = index["files"][0];
    EXPECT_EQ(index["options"]["root"], json::parse("[" + root + "]"));
    EXPECT_EQ(part["n_v"], *largest);
    EXPECT_LE(4 * part["n_v"].get<int>(), whole["n_v"].get<int>());
    EXPECT_NE(part["file"], whole["file"]);
    // The roots' part is everything.
    draw(scene + " --root 0,0", "all");
    json all = json::parse(file("all", "index.json"))["files"][0];
    EXPECT_EQ(all["n_v"], whole["n_v"]);
    EXPECT_EQ(all["n_u"], whole["n_u"]);
    // One that was not made names some that were.
    const ProgramRun none =
        run_scb("render traversal " + scene + " --root 1,40000 -o " + (folder / "none"));
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("try " + root), std::string::npos) << none.err;
}

TEST_F(RenderTraversal, RefusesWhatItDoesNotUnderstand) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"--by time", "give tests or share"}, {"--show all", "give matrix, icicle, both or bounds"},
        {"--frames 500", "0 to 499"},         {"--root 5", "this is not a pair of nodes"},
        {"--root 5,-1", "counted from 0"},    {"--root 5,4294967295", "no node has such a number"},
        {"--camera fit", "--camera"},         {"--ids", "--ids"},
        {"--samples 4", "--samples"},         {"--ortho", "--ortho"},
        {"--clip 0,0,1,0", "--clip"}};
    for (const auto& [arguments, message] : cases) {
        const ProgramRun run =
            run_scb("render traversal spheres-l1 " + arguments + " -o " + (folder / "none"));
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST_F(RenderTraversal, BoundsOfADistance) {
    draw("spheres-l1 --frames 0,100 --kind distance --order nearest", "out");
    const json index = json::parse(file("out", "index.json"));
    EXPECT_EQ(index["options"]["show"], "bounds");
    EXPECT_EQ(index["volume"], "scb2");
    ASSERT_EQ(index["files"].size(), 2u);
    const json live =
        json::parse(run_scb("distance spheres-l1 --frames 0,100 --order nearest --json").out);
    for (std::size_t i = 0; i < 2; ++i)
        for (const char* key : {"distance", "n_v", "n_p"})
            EXPECT_EQ(index["files"][i][key], live["frames"][i][key]) << key;
    const std::string name = index["files"][0]["file"];
    EXPECT_NE(name.find("kind-distance"), std::string::npos) << name;
    EXPECT_GT(file("out", name).size(), 1000u);
    // Volumes that were chosen stay, and so does the diagram.
    draw("spheres-l1 --frames 0 --kind distance --volume obb --show icicle", "obb");
    EXPECT_EQ(json::parse(file("obb", "index.json"))["volume"], "obb");
    EXPECT_EQ(json::parse(file("obb", "index.json"))["options"]["show"], "icicle");
}

TEST_F(RenderTraversal, RefusesOptionsOfTheOtherKindOfQuery) {
    const auto error = [this](const std::string& arguments) {
        const ProgramRun run = run_scb("render traversal spheres-l1 --frames 0 " + arguments +
                                       " -o " + (folder / "o"));
        EXPECT_EQ(run.status, 2) << arguments;
        return run.err;
    };
    EXPECT_NE(error("--show bounds").find("--kind distance"), std::string::npos);
    EXPECT_NE(error("--kind distance --test exact").find("--test"), std::string::npos);
    EXPECT_NE(error("--kind distance --within -1").find("0 or more"), std::string::npos);
    EXPECT_NE(error("--query other").find("recording"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
