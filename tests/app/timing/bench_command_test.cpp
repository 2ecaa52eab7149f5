#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "render/files/image_file.h"
#include "tests/app/program.h"
#include "tests/real_models.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(BenchCommand, HasTheCountsOfCollide) {
    const TemporaryFolder folder;
    const ProgramRun run =
        run_scb("bench spheres-l1 --frames 100,250 --repeat 1 --json -o " + (folder / "out"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json scene = json::parse(run.out)["scenes"][0];
    EXPECT_EQ(scene["scene"], "spheres-l1");
    ASSERT_EQ(scene["hierarchies"].size(), 4u);
    for (const json& row : scene["hierarchies"]) {
        const std::string volume = row["volume"];
        const json mean = json::parse(
            run_scb("collide spheres-l1 --frames 100,250 --json --volume " + volume).out)["mean"];
        for (const char* count : {"n_v", "n_p", "n_u", "pairs"})
            EXPECT_EQ(row[count], mean[count]) << volume << " " << count;
        EXPECT_GT(row["ms"], 0);
        // It would be no fair comparison with some of the frames.
        EXPECT_FALSE(row.contains("table_3"));
    }

    EXPECT_EQ(json::parse(file_text(folder / "out/bench.json"))["scenes"].size(), 1u);
    const std::string csv = file_text(folder / "out/bench.csv");
    EXPECT_EQ(lines_of(csv), 1u + 4 * 2);
    const render::Image picture = render::read_png(folder / "out/spheres-l1_bench.png");
    EXPECT_EQ(picture.width, 1280);
    EXPECT_EQ(picture.height, 720);
}

TEST(BenchCommand, NamesThePoseInItsFiles) {
    const TemporaryFolder folder;
    const std::string mesh = folder / "level.ply", out = folder / "out";
    ASSERT_EQ(run_scb("export spheres-l1 --levels 3 -o " + mesh).status, 0);
    for (const char* pose : {"1,0,0,0.25,0,1,0,0,0,0,1,0", "1,0,0,0.5,0,1,0,0,0,0,1,0"}) {
        const ProgramRun run = run_scb("bench " + mesh + " " + mesh +
                                       " --frames 0 --repeat 1 --pose " + pose + " -o " + out);
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find(std::string("Pose of B: ") + pose), std::string::npos) << run.out;
        // A single query does not determine the costs of its parts.
        EXPECT_NE(run.out.find("cannot tell its costs apart"), std::string::npos) << run.out;
        EXPECT_EQ(run.out.find("C_v ns"), std::string::npos) << run.out;
    }
    EXPECT_EQ(files_in(out), 6u);
}

TEST(BenchCommand, HasTable3BesideWhereAllFramesAreRun) {
    const ProgramRun run = run_scb("bench knots-l3 --repeat 1 --volume scb,ritter --json");
    ASSERT_EQ(run.status, 0) << run.err;
    const json rows = json::parse(run.out)["scenes"][0]["hierarchies"];
    EXPECT_EQ(rows[0]["table_3"]["n_v"], 14367);
    EXPECT_FALSE(rows[1].contains("table_3"));
}

TEST(BenchCommand, FindsTheSamePairsInEveryLayout) {
    const std::string query = "bench spheres-l1 --frames 100,250 --repeat 1 --volume scb --json ";
    const std::string layouts =
        "--layout "
        "reference,float2,float4,float8,quantized2,quantized4,quantized8,indexed2,indexed8 ";
    std::vector<json> answers;
    for (const std::string& how :
         {std::string(), std::string("--simd base"), std::string("--threads 2"),
          std::string("--leaf 1"), std::string("--split cost")}) {
        const ProgramRun run = run_scb(query + layouts + how);
        ASSERT_EQ(run.status, 0) << run.err;
        answers.push_back(json::parse(run.out)["scenes"][0]["hierarchies"]);
        ASSERT_EQ(answers.back().size(), 9u);
        EXPECT_FALSE(answers.back()[0].contains("layout"));
        for (const json& row : answers.back()) {
            EXPECT_EQ(row["pairs"], answers[0][0]["pairs"]) << row << how;
            EXPECT_GT(row["bytes_per_triangle"], 0);
        }
    }
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(answers[1][i]["n_v"], answers[0][i]["n_v"]) << i;
        EXPECT_EQ(answers[2][i]["n_v"], answers[0][i]["n_v"]) << i;
    }
    EXPECT_GT(answers[3][6]["n_v"], answers[0][6]["n_v"]) << "more leaves";
    EXPECT_LT(answers[0][6]["bytes_per_triangle"], answers[0][3]["bytes_per_triangle"]);
    EXPECT_NEAR(answers[0][6]["bytes_per_triangle"].get<double>() -
                    answers[0][8]["bytes_per_triangle"].get<double>(),
                36, 1e-6)
        << "without corners";
    EXPECT_LT(answers[4][0]["n_v"], answers[0][0]["n_v"]) << "split at least cost";
}

TEST(BenchCommand, TimesPackedLayoutsAlsoWithFrontReuse) {
    const TemporaryFolder folder;
    const ProgramRun run = run_scb(
        "bench knots-l1 --frames 0:9 --repeat 2 --volume scb --layout reference,float8 "
        "--coherent --json -o " +
        (folder / "out"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json rows = json::parse(run.out)["scenes"][0]["hierarchies"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_FALSE(rows[1].contains("from_front"));
    // The knots do not move relative to each other: the first query begins at the roots, the second
    // makes a front.
    EXPECT_EQ(rows[2]["from_front"], 0.8);
    EXPECT_EQ(rows[2]["pairs"], rows[1]["pairs"]);
    EXPECT_LT(rows[2]["n_v"], rows[1]["n_v"]);
    EXPECT_NE(file_text(folder / "out/bench.csv").find("knots-l1,scb,float8 front,0,"),
              std::string::npos);
    EXPECT_EQ(run_scb("bench soup --frames 0 --volume scb --coherent").status, 2);
}

TEST(BenchCommand, EndsQueriesAtTheFirstPair) {
    const std::string bench =
        "bench spheres-l1 --frames 0,100,120,260 --repeat 2 --volume scb --layout "
        "reference,quantized8 ";
    const auto rows = [&](const std::string& options) {
        const ProgramRun run = run_scb(bench + "--json " + options);
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(run.out)["scenes"][0]["hierarchies"];
    };
    const json first = rows("--first --coherent"), all = rows("");
    ASSERT_EQ(first.size(), 3u);
    for (std::size_t s = 0; s < first.size(); ++s) {
        EXPECT_EQ(first[s]["pairs"], 0.75) << "of four frames, three have contact";
        EXPECT_LT(10 * first[s]["n_v"].get<double>(), all[s % 2]["n_v"].get<double>()) << s;
        EXPECT_FALSE(first[s].contains("pairs_hash")) << "pairs depend on the hierarchy";
    }
    const ProgramRun table = run_scb(bench + "--first --threads 2");
    EXPECT_NE(table.out.find("All found the same answers."), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("One thread"), std::string::npos) << table.out;
    EXPECT_NE(table.err.find("--threads has no effect"), std::string::npos) << table.err;
}

TEST(BenchCommand, HasTheCountsAndDistancesOfScbDistance) {
    const TemporaryFolder folder;
    const std::string query = " spheres-l1 --frames 0,120 ";
    const ProgramRun run = run_scb("bench" + query +
                                   "--kind distance --order nearest --volume scb,scb2,rss --layout "
                                   "reference,quantized8 --repeat 1 --json -o " +
                                   (folder / "out"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json document = json::parse(run.out);
    EXPECT_EQ(document["options"]["query"], "distance");
    EXPECT_EQ(document["options"]["order"], "nearest");
    const json& rows = document["scenes"][0]["hierarchies"];
    ASSERT_EQ(rows.size(), 5u);
    for (const json& row : rows) {
        const std::string layout = row.value("layout", "reference");
        const json frames = json::parse(
            run_scb("distance" + query + "--order nearest --split paper --json --volume " +
                    row["volume"].get<std::string>() + " --layout " + layout)
                .out)["frames"];
        const auto mean = [&](const char* key) {
            return (frames[0][key].get<double>() + frames[1][key].get<double>()) / 2;
        };
        for (const char* key : {"n_v", "n_p", "distance"})
            EXPECT_EQ(row[key], mean(key)) << row << key;
        EXPECT_FALSE(row.contains("pairs")) << row;
        EXPECT_FALSE(row.contains("test")) << row;
    }
    EXPECT_TRUE(file_text(folder / "out/bench.csv")
                    .starts_with("scene,hierarchy,test,frame,ms,n_v,n_p,n_u,distance,split\n"));
    const ProgramRun table =
        run_scb("bench" + query + "--kind distance --repeat 1 --volume scb,obb");
    EXPECT_NE(table.out.find("frames, distance\n"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("All found the same distances."), std::string::npos) << table.out;
}

TEST(BenchCommand, TimesQueriesWithinATolerance) {
    const std::string bench =
        "bench spheres-l1 --frames 0,100 --repeat 1 --volume scb,scb2 --layout "
        "reference,float8 --json --within ";
    const json all = json::parse(run_scb(bench + "0.06").out),
               first = json::parse(run_scb(bench + "0.06 --first").out),
               none = json::parse(run_scb(bench + "0.0001 --first").out);
    const json found = json::parse(
        run_scb("distance spheres-l1 --frames 0,100 --within 0.06 --json").out)["frames"];
    const double pairs = (found[0]["pairs"].get<double>() + found[1]["pairs"].get<double>()) / 2;
    EXPECT_EQ(all["options"]["query"], "within");
    EXPECT_EQ(all["options"]["tolerance"], 0.06);
    for (std::size_t s = 0; s < 4; ++s) {
        EXPECT_EQ(all["scenes"][0]["hierarchies"][s]["pairs"], pairs) << s;
        EXPECT_EQ(first["scenes"][0]["hierarchies"][s]["pairs"], 1) << s;
        EXPECT_EQ(none["scenes"][0]["hierarchies"][s]["pairs"], 0.5) << s;
    }
}

TEST(BenchCommand, RefusesOptionsOfOtherKinds) {
    const std::string bench = "bench spheres-l1 --frames 0 --repeat 1 ";
    for (const char* options :
         {"--order nearest", "--relative-error 0.1", "--limit 1", "--kind distance --first",
          "--kind distance --test corrected", "--kind distance --layout float8 --coherent",
          "--within 1 --measures", "--within 1 --order nearest", "--within -1", "--kind self"}) {
        const ProgramRun run = run_scb(bench + options);
        EXPECT_EQ(run.status, 2) << options;
        EXPECT_EQ(run.out, "") << options;
    }
}

TEST(BenchCommand, CorrelatesMeasuresWithWhatQueriesTook) {
    const TemporaryFolder folder;
    const ProgramRun run = run_scb(
        "bench knots-l1 soup --frames 0,100 --repeat 1 --volume scb,ball,obb --test "
        "symmetric,extents --layout reference,float8 --split paper,cost --measures --json -o " +
        (folder / "out"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json document = json::parse(run.out);
    // Both splits of two tests and a packed layout of slab cut balls, balls and boxes.
    const json& rows = document["scenes"][0]["hierarchies"];
    ASSERT_EQ(rows.size(), 10u);
    EXPECT_EQ(rows[0]["hierarchy"], "SCB symmetric, paper");
    EXPECT_EQ(rows[5]["hierarchy"], "SCB symmetric, cost");
    EXPECT_LT(rows[5]["n_v"], rows[0]["n_v"]);
    EXPECT_EQ(rows[0]["measures"], rows[1]["measures"]) << "one hierarchy, two tests";
    EXPECT_FALSE(rows[2].contains("measures")) << "packed";
    EXPECT_LT(rows[5]["measures"]["area"], rows[0]["measures"]["area"]);
    const json& correlation = document["correlation"];
    EXPECT_EQ(correlation.size(), 9u);
    for (const json& row : correlation)
        for (const char* cost : {"n_v", "n_p", "ms"}) {
            EXPECT_EQ(row[cost]["queries"], 2 * 6) << row;
            EXPECT_EQ(row[cost]["scenes"].size(), 2u);
            EXPECT_TRUE(row[cost]["mean"].is_null() ||
                        std::abs(row[cost]["mean"].get<double>()) <= 1);
        }
    EXPECT_EQ(lines_of(file_text(folder / "out/measures.csv")), 1u + 2 * 6);
    EXPECT_EQ(render::read_png(folder / "out/measures.png").width, 1280);
    EXPECT_EQ(run_scb("bench soup --volume scb --layout float8 --measures").status, 2);
    EXPECT_EQ(run_scb("bench soup --split paper,best").status, 2);
}

TEST(BenchCommand, NotesWhatHasNoEffect) {
    const auto notes = [](const std::string& arguments) {
        const ProgramRun run = run_scb("bench soup --frames 0 --repeat 1 " + arguments);
        EXPECT_EQ(run.status, 0) << run.err;
        return run.err;
    };
    for (const std::string option : {"--test printed", "--threshold 0.5", "--descent area"}) {
        const std::string packed = notes("--volume scb --layout float8 " + option);
        EXPECT_NE(packed.find("scb: " + option.substr(0, option.find(' ')) + " has no effect"),
                  std::string::npos)
            << packed;
        EXPECT_EQ(packed.find("may be missing"), std::string::npos) << packed;
    }
    const std::string balls = notes("--volume ball --layout float8 --leaf 2");
    EXPECT_NE(balls.find("--layout has no effect: only slab cut"), std::string::npos) << balls;
    EXPECT_NE(balls.find("--leaf has no effect: only slab cut"), std::string::npos) << balls;
    EXPECT_NE(notes("--leaf 2").find("--leaf has no effect"), std::string::npos);
    EXPECT_NE(notes("--simd base").find("--simd has no effect"), std::string::npos);
    EXPECT_EQ(notes("--layout reference,float8 --test extents --leaf 2 --simd base"), "");
    EXPECT_EQ(notes("--volume scb,ball --layout float8 --descent area"), "");
    // Without a packed layout no query is shared.
    EXPECT_EQ(run_scb("bench soup --frames 0 --repeat 1 --threads 2").out.find("share"),
              std::string::npos);
    EXPECT_NE(run_scb("bench soup --frames 0 --repeat 1 --threads 2 --layout float8")
                  .out.find("2 threads share"),
              std::string::npos);
}

TEST(BenchCommand, TwoScenesAreNotTwoBodies) {
    const ProgramRun run = run_scb("bench soup cone --frames 0 --repeat 1 --volume scb");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err.find("same pose"), std::string::npos) << run.err;
}

TEST(BenchCommand, RefusesLayoutsAndLevelsThatAreNot) {
    for (const char* arguments : {"--layout float3", "--simd avx3", "--leaf 5", "--leaf 0",
                                  "--threads 0", "--threads 1000", "--layout reference,"}) {
        const ProgramRun run = run_scb(std::string("bench soup --frames 0 ") + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(std::string(arguments).substr(0, 6)), std::string::npos) << run.err;
    }
}

TEST(BenchCommand, TakesTwoMeshFiles) {
    const TemporaryFolder folder;
    const std::string mesh = folder / "level.ply";
    ASSERT_EQ(run_scb("export spheres-l1 --level 3 -o " + mesh).status, 0);
    const ProgramRun run =
        run_scb("bench " + mesh + " " + mesh + " --repeat 1 --volume scb --json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["scenes"].size(), 1u);
    EXPECT_EQ(run_scb("bench knots-l1 knots-l1").status, 2);
}

TEST(BenchCommand, LeavesWhatWasFinishedWhenInterrupted) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    // The second scene takes longer than the signal; that comes once the first is finished.
    const ProgramRun run = run_scb_interrupted(
        "bench knots-l1 spheres-l1 --frames 0:499:50 --volume scb --repeat 100 --quiet -o " + out,
        [&](pid_t) { return fs::exists(out + "/bench.json"); }, SIGTERM);
    EXPECT_EQ(run.status, 143) << run.err;
    const json result = json::parse(file_text(folder / "out/bench.json"));
    ASSERT_EQ(result["scenes"].size(), 1u);
    EXPECT_EQ(result["scenes"][0]["scene"], "knots-l1");
    EXPECT_TRUE(fs::exists(folder / "out/knots-l1_bench.png"));
    EXPECT_FALSE(fs::exists(folder / "out/spheres-l1_bench.png"));
}

TEST(BenchCommand, RefusesASceneBeforeMeasuringAnother) {
    const TemporaryFolder folder;
    const ProgramRun run = run_scb("bench knots-l1 nonsense -o " + (folder / "out"));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(BenchCommand, LeavesOutScenesOfAGroupWhoseMeshesAreNotThere) {
    const TemporaryFolder models;
    const std::string here = " --frames 0 --repeat 1 --volume scb --models " + models.path.string();
    const ProgramRun run = run_scb("bench cad soup --json" + here);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["scenes"].size(), 1u);
    for (const char* name : {"aatbase", "tube"})
        EXPECT_NE(run.err.find(std::string("scb: ") + name + " is left out: it needs " + name),
                  std::string::npos)
            << run.err;
    const ProgramRun none = run_scb("bench cad" + here);
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("there is no scene to measure"), std::string::npos) << none.err;
    // One that is named itself is not left out.
    EXPECT_EQ(run_scb("bench soup tube" + here).status, 2);
}

TEST(BenchCommand, ComparesCadScenesWithNoNumberOfThePaper) {
    if (!has_model_file("anchor.ply", "scb bench of CAD scenes")) GTEST_SKIP();
    const std::string models = " --repeat 1 --volume scb,obb --models " + models_folder().string();
    const ProgramRun run = run_scb("bench cad --frames 300 --json" + models);
    ASSERT_EQ(run.status, 0) << run.err;
    const json scenes = json::parse(run.out)["scenes"];
    ASSERT_EQ(scenes.size(), 8u);
    for (const json& scene : scenes)
        EXPECT_EQ(scene["hierarchies"][0]["pairs"], scene["hierarchies"][1]["pairs"]) << scene;
    const ProgramRun all_frames = run_scb("bench anchor" + models);
    EXPECT_EQ(all_frames.out.find("Table 3"), std::string::npos) << all_frames.out;
    EXPECT_NE(all_frames.out.find("All found the same pairs"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
