#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

json hierarchies(const std::string& arguments) {
    const ProgramRun run = run_scb("stats spheres-l1 --json " + arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out)["hierarchies"];
}

TEST(StatsCommand, ReportsThePackedLayoutsOfSlabCutBalls) {
    const json all = hierarchies("--volume scb,ball");
    ASSERT_EQ(all.size(), 4u);  // two spheres, two volumes
    EXPECT_FALSE(all[1].contains("packed"));
    const json& packed = all[0]["packed"];
    EXPECT_EQ(packed.size(), 9u);
    double indexed8 = 0, quantized8 = 0;
    for (const json& layout : packed) {
        const double per_triangle = layout["bytes_per_triangle"];
        EXPECT_NEAR(layout["bytes"].get<double>() / all[0]["triangles"].get<double>(), per_triangle,
                    1e-9);
        if (layout["layout"] == "indexed8") indexed8 = per_triangle;
        if (layout["layout"] == "quantized8") quantized8 = per_triangle;
    }
    EXPECT_GT(indexed8, 30);
    EXPECT_LT(indexed8, 40);
    EXPECT_GT(quantized8, 60);
    EXPECT_LT(quantized8, 80);
}

TEST(StatsCommand, SaysWhatTheMeshesAre) {
    const auto facts_of = [](const std::string& scene) -> json {
        return json::parse(run_scb("stats " + scene + " --json").out)["hierarchies"][0]["facts"];
    };
    const json facts = facts_of("knots-l1");
    EXPECT_EQ(facts["closed"], true);
    EXPECT_EQ(facts["components"], 1);
    EXPECT_EQ(facts["degenerate"], 0);
    EXPECT_EQ(facts["slender"], 0);
    EXPECT_GT(facts_of("long-triangles")["slender"], 0);
    EXPECT_LT(facts["box"]["lower"][0], facts["box"]["upper"][0]);
    const std::string text = run_scb("stats soup").out;
    for (const char* part : {"box          ", "open: ", " components", "slenderness  median "})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(StatsCommand, ReportsTheLayoutsAndLeavesAskedFor) {
    const json few = hierarchies("--layout indexed8,float2 --leaf 1")[0]["packed"];
    ASSERT_EQ(few.size(), 2u);
    EXPECT_EQ(few[0]["layout"], "indexed8");
    EXPECT_EQ(few[1]["layout"], "float2");
    EXPECT_GT(few[0]["bytes"], hierarchies("--layout indexed8")[0]["packed"][0]["bytes"]);
}

TEST(StatsCommand, SaysWhatHasNoEffectAndHowHierarchiesAreBuilt) {
    const ProgramRun ball = run_scb("stats spheres-l1 --volume ball --layout float8");
    EXPECT_EQ(ball.status, 0);
    EXPECT_NE(ball.err.find("no effect"), std::string::npos) << ball.err;
    const ProgramRun cost = run_scb("stats spheres-l1 --split cost --growth radius");
    EXPECT_NE(cost.out.find("scb hierarchy, growth radius, split by cost"), std::string::npos);
    EXPECT_EQ(cost.err, "");
}

TEST(BuildText, IsInEveryCommandThatBuilds) {
    for (const std::string command :
         {"stats soup", "collide soup --frames 0", "bench soup --frames 0 --repeat 1",
          "inspect soup --frame 60", "explain soup --pair 0,0"}) {
        EXPECT_EQ(run_scb(command).out.find("margin 0.25"), std::string::npos) << command;
        const ProgramRun run = run_scb(command + " --margin 0.25 --split cost");
        EXPECT_NE(run.out.find("margin 0.25, split by cost"), std::string::npos)
            << command << run.out << run.err;
    }
}

// The times differ, the hierarchy does not.
TEST(StatsCommand, IsTheSameForAnyNumberOfThreads) {
    const auto without_times = [](json all) {
        for (json& hierarchy : all) {
            hierarchy.erase("time");
            for (json& layout : hierarchy["packed"]) layout.erase("ms");
        }
        return all;
    };
    EXPECT_EQ(without_times(hierarchies("--threads 2")), without_times(hierarchies("")));
}

}  // namespace
}  // namespace scb::app
