#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct DistanceTrace : testing::Test {
    TemporaryFolder folder;

    ProgramRun run(const std::string& command) {
        return run_scb("--quiet " + command, {.folder = folder.path.string(), .environment = {}});
    }
    void record(const std::string& options, const std::string& file) {
        const ProgramRun recorded = run("trace spheres-l1 " + options + " -o " + file);
        ASSERT_EQ(recorded.status, 0) << recorded.err;
    }
    void expect_refused(const std::string& command, const std::string& words) {
        const ProgramRun refused = run(command);
        EXPECT_EQ(refused.status, 2) << command;
        EXPECT_NE(refused.err.find(words), std::string::npos) << command << refused.err;
        EXPECT_EQ(refused.out, "") << command;
    }
};

TEST_F(DistanceTrace, PrintsWhatDistanceDoes) {
    for (const char* options :
         {"", "--order nearest", "--order depth-first --volume rss --split paper", "--limit 0.1",
          "--relative-error 0.1", "--within 0.06", "--within 0.06 --first", "--descent volume"}) {
        SCOPED_TRACE(options);
        const std::string asked = std::string("--frames 0,100,300 ") + options;
        record("--kind distance " + asked, "t.scbrec");
        const json trace = json::parse(run("trace t.scbrec --json").out),
                   live = json::parse(run("distance spheres-l1 --json " + asked).out);
        ASSERT_EQ(trace["frames"].size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
            for (const char* key : {"frame", "pose", "distance", "triangles", "points", "rounding",
                                    "n_v", "n_p", "n_u", "stages", "pairs_hash"}) {
                const json &of_trace = trace["frames"][i], &of_live = live["frames"][i];
                if (!of_live.contains(key)) continue;
                EXPECT_EQ(of_trace.value(key, json()), of_live[key]) << key;
            }
        EXPECT_EQ(trace["volume"], live["volume"]);
        EXPECT_EQ(trace["split"], live["split"]);
        // The table has the numbers of the table of `scb distance`.
        const std::vector<std::string> table = lines(run("trace t.scbrec").out),
                                       of_live = lines(run("distance spheres-l1 " + asked).out);
        for (const std::string& row : of_live) {
            if (!row.starts_with("    0 ") && !row.starts_with("frame ")) continue;
            EXPECT_NE(std::find(table.begin(), table.end(), row), table.end()) << row;
        }
    }
}

TEST_F(DistanceTrace, ShowsEveryTest) {
    record("--kind distance --frames 0", "t.scbrec");
    const std::string events = run("trace t.scbrec --events").out;
    for (const char* words : {"near, passed on to the children of", "near, not needed any more",
                              "left out at slab-a", "were nearer than all before"})
        EXPECT_NE(events.find(words), std::string::npos) << words;
    EXPECT_EQ(events.find("intersect"), std::string::npos);
    const json trace = json::parse(run("trace t.scbrec --json --events").out);
    EXPECT_EQ(trace["frames"][0]["tests"].size(), trace["frames"][0]["n_v"]);
}

TEST_F(DistanceTrace, TheSameBytesTwice) {
    record("--kind distance --frames 0,100", "a.scbrec");
    record("--kind distance --frames 0,100", "b.scbrec");
    EXPECT_EQ(file_text(folder / "a.scbrec"), file_text(folder / "b.scbrec"));
}

TEST_F(DistanceTrace, IsDrawnAsTheQueryOfTheScene) {
    record("--kind distance --order nearest --frames 0", "t.scbrec");
    const ProgramRun traced = run("render traversal t.scbrec -o traced"),
                     made =
                         run("render traversal spheres-l1 --frames 0 --kind distance --order "
                             "nearest -o made");
    ASSERT_EQ(traced.status, 0) << traced.err;
    ASSERT_EQ(made.status, 0) << made.err;
    const std::filesystem::path traced_folder = folder / "traced", made_folder = folder / "made";
    json of_traced = json::parse(file_text(traced_folder / "index.json")),
         of_made = json::parse(file_text(made_folder / "index.json"));
    const std::string name = of_made["files"][0]["file"];
    // Only a trace needs to know the rounding.
    EXPECT_EQ(of_traced["files"][0].erase("rounding"), 1u);
    EXPECT_EQ(of_traced["files"], of_made["files"]);
    EXPECT_EQ(png_without_texts(file_text(traced_folder / name)),
              png_without_texts(file_text(made_folder / name)));
    record("--kind distance --within 0.06 --frames 0", "near.scbrec");
    EXPECT_EQ(run("render traversal near.scbrec -o near").status, 0);
}

TEST_F(DistanceTrace, IsInspectedAsItsQueryIs) {
    record("--kind distance --frames 0", "t.scbrec");
    const json of_trace = json::parse(run("inspect t.scbrec --json").out),
               of_query =
                   json::parse(run("inspect spheres-l1 --kind distance --frames 0 --json").out);
    EXPECT_EQ(of_trace["sum"], of_query["sum"]);
    EXPECT_EQ(of_trace["frames"], of_query["frames"]);
}

TEST_F(DistanceTrace, HasAPage) {
    record("--kind distance --frames 0", "t.scbrec");
    const ProgramRun page = run("view t.scbrec -o page.html");
    EXPECT_EQ(page.status, 0) << page.err;
    EXPECT_NE(file_text(folder / "page.html").find("scb render traversal t.scbrec"),
              std::string::npos);
    record("--kind distance --within 0.06 --frames 0", "near.scbrec");
    expect_refused("view near.scbrec -o page.html", "the page shows the smallest distance");
}

TEST_F(DistanceTrace, IsRefusedByCommandsForOverlap) {
    record("--kind distance --frames 0", "t.scbrec");
    record("--frames 0", "overlap.scbrec");
    for (const char* command : {"render pairs t.scbrec -o out", "render rejections t.scbrec -o out",
                                "explain t.scbrec --pair 0,0"})
        expect_refused(command, "t.scbrec: its queries are of distances");
    for (const char* command : {"diff t.scbrec overlap.scbrec", "diff overlap.scbrec t.scbrec",
                                "view t.scbrec overlap.scbrec -o page.html"})
        expect_refused(command, "kind");
    EXPECT_FALSE(std::filesystem::exists(folder / "page.html"));
}

TEST_F(DistanceTrace, RefusesOptionsOfOverlap) {
    for (const char* option :
         {"--test extents", "--max-pairs 3", "--levels 3", "--records", "--layout quantized8"})
        expect_refused(std::string("trace spheres-l1 --kind distance -o t.scbrec ") + option,
                       "it is for queries of overlap");
    expect_refused("trace spheres-l1 --order nearest -o t.scbrec", "add --kind distance");
    expect_refused("trace spheres-l1 --kind distance --first -o t.scbrec",
                   "--first needs --within T.");
    expect_refused("trace spheres-l1 --first -o t.scbrec", "--first needs --within T.");
    EXPECT_FALSE(std::filesystem::exists(folder / "t.scbrec"));
    record("--kind distance --frames 0", "t.scbrec");
    expect_refused("trace t.scbrec --kind distance", "--kind");
    expect_refused("trace t.scbrec --order nearest", "--order");
}

TEST_F(DistanceTrace, DiffComparesAnswersAndTests) {
    record("--kind distance --frames 0:499:100", "a.scbrec");
    record("--kind distance --frames 0:499:100 --order nearest", "b.scbrec");
    record("--kind distance --frames 0:499:100 --limit 0.01", "c.scbrec");
    const ProgramRun same = run("diff a.scbrec a.scbrec");
    EXPECT_EQ(same.status, 0);
    EXPECT_NE(same.out.find("equal: 5 frames"), std::string::npos) << same.out;
    const ProgramRun order = run("diff a.scbrec b.scbrec");
    EXPECT_EQ(order.status, 1);
    for (const char* words : {"order       hybrid  nearest", "with the same distance, but other",
                              "They part first at frame 0, test", "near "})
        EXPECT_NE(order.out.find(words), std::string::npos) << words << order.out;
    EXPECT_EQ(order.out.find("answer differs"), std::string::npos) << order.out;
    EXPECT_EQ(order.out.find("pairs"), std::string::npos) << order.out;
    const ProgramRun limit = run("diff a.scbrec c.scbrec");
    EXPECT_EQ(limit.status, 1);
    for (const char* words : {"with other distances (frame", "of the triangles (",
                              "in the first, no triangles within the limit in the second"})
        EXPECT_NE(limit.out.find(words), std::string::npos) << words << limit.out;
    const json document = json::parse(run("diff a.scbrec c.scbrec --json").out);
    const json& frame = document["frames"][0];
    EXPECT_EQ(frame["distances_differ"], true);
    EXPECT_GT(frame["distance"]["a"], 0.01);
    EXPECT_EQ(frame["distance"]["b"], json());
    EXPECT_EQ(frame["triangles"]["a"].size(), 2u);
    EXPECT_GT(frame["rounding"], 0);
    EXPECT_FALSE(frame["counts"].contains("pairs"));
}

TEST_F(DistanceTrace, AFailedCaseOfAGoldenSuiteHasOne) {
    const auto suite = [&](const std::string& order) {
        write_text(folder / "cases.json",
                   R"({"scb_golden": 2, "cases": [{"name": "near", "run": "distance", "frames": "0",
                       "scene": "spheres-l1", "arguments": ["--order", ")" +
                       order + R"("]}]})");
    };
    suite("nearest");
    const ProgramRun update = run("golden update --suite cases.json --all");
    ASSERT_EQ(update.status, 0) << update.err;
    EXPECT_EQ(run("golden check --suite cases.json").status, 0);
    suite("depth-first");
    const ProgramRun check = run("golden check --suite cases.json --trace --report report");
    EXPECT_EQ(check.status, 1);
    const std::string said = check.out + check.err;
    EXPECT_NE(said.find("They part first at frame 0, test"), std::string::npos) << said;
    EXPECT_NE(said.find("near, "), std::string::npos) << said;
    EXPECT_EQ(run("diff report/near.baseline.scbrec report/near.new.scbrec").status, 1);
    EXPECT_TRUE(std::filesystem::exists(folder / "report/near.view.html"));
}

}  // namespace
}  // namespace scb::app
