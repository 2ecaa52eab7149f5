#include <gtest/gtest.h>

#include <algorithm>
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
    for (const char* part :
         {"box          ", "not closed: ", " components", "slenderness  median "})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(StatsCommand, NotesWhatOfAMeshIsLeftOut) {
    const TemporaryFolder folder;
    const std::string file = folder.write("skin.gltf", R"({"asset": {"version": "2.0"},
"nodes": [{"mesh": 0, "skin": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    const ProgramRun run = run_scb("stats " + file);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "scb: " + file +
                           ": its skins are left out; the mesh has the shape that is stored before "
                           "them.\n");
    EXPECT_EQ(run_scb("--quiet stats " + file).err, "");
    EXPECT_EQ(run_scb("stats cone").err, "");
}

TEST(StatsCommand, SaysThatRoundingErrorsOfABoxAre0) {
    const TemporaryFolder folder;
    const std::string flat =
        folder.write("flat.off", "OFF\n3 1 0\n0 0 4.5e-16\n1 0 0\n0 1e-6 0\n3 0 1 2\n");
    const std::string text = run_scb("stats " + flat).out;
    EXPECT_NE(text.find("0, 0, 0 to 1, 1e-06, 0\nsize         1, 1e-06, 0\n"), std::string::npos)
        << text;
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
    EXPECT_NE(cost.out.find(", growth radius,"), std::string::npos);
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

TEST(StatsCommand, MeasuresWhereAskedTo) {
    EXPECT_FALSE(hierarchies("")[0].contains("measures"));
    for (const json& hierarchy : hierarchies("--volume scb,aabb --measures")) {
        const json& measures = hierarchy["measures"];
        for (const char* name :
             {"area", "volume", "sah_cost", "epo", "sibling_overlap", "overlap_volume", "tightness",
              "hull_volume", "leaf_count", "lcv"}) {
            EXPECT_GT(measures[name], 0) << name << hierarchy["volume"];
            EXPECT_TRUE(measures.contains(name));
        }
        EXPECT_LT(measures["epo_error"].get<double>(), 0.02 * measures["epo"].get<double>());
        EXPECT_EQ(hierarchy["levels"][0]["sah_cost"], 1.2);
        EXPECT_EQ(hierarchy["levels"][0]["epo"], 0);
    }
    const std::string text = run_scb("stats spheres-l1 --measures").out;
    for (const char* part :
         {"SAH cost       EPO    tight  overlap", "  all ", "\nEPO ", "\nsolid: nodes"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(StatsCommand, HasALineOfCsvPerLevelAndOneOfAll) {
    for (const std::string measures : {"", " --measures"}) {
        const ProgramRun run = run_scb("stats knots-l1 --volume scb,obb --csv" + measures);
        ASSERT_EQ(run.status, 0) << run.err;
        const std::vector<std::string> rows = lines(run.out);
        // A body of 15 levels and one of 17, twice.
        EXPECT_EQ(rows.size(), 1u + 2 * 16 + 2 * 18);
        const auto columns = [](const std::string& row) {
            return std::count(row.begin(), row.end(), ',');
        };
        for (const std::string& row : rows) EXPECT_EQ(columns(row), columns(rows[0])) << row;
        EXPECT_EQ(columns(rows[0]), measures.empty() ? 13 : 26);
        EXPECT_EQ(rows[1].substr(0, 24), "knot,A,scb,paper,0,1,0,1");
        EXPECT_NE(rows[16].find(",scb,paper,all,7055,3528,,"), std::string::npos) << rows[16];
    }
    EXPECT_EQ(run_scb("stats soup --csv --json").status, 2);
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
    EXPECT_EQ(without_times(hierarchies("--measures --threads 4")),
              without_times(hierarchies("--measures")));
}

TEST(StatsCommand, HasLinesOfAtMost100Columns) {
    for (const std::string scene : {"spheres-l1", "long-triangles", "soup"})
        for (const std::string& line :
             lines(run_scb("stats " + scene + " --volume scb,obb --measures").out))
            EXPECT_LE(line.size(), 100u) << line;
}

}  // namespace
}  // namespace scb::app
