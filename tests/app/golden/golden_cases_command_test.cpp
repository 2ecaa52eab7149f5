#include <nlohmann/json.hpp>
#include <regex>

#include "tests/app/golden/golden_command.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What cases may be, and where what they name is looked for.
class GoldenCommandCases : public testing::Test {
  protected:
    GoldenCommandCases() {
        fs::create_directory(folder / "my");
        fs::create_directory(folder / "models");
    }
    void write_cases(const json& cases) const {
        write_text(suite, json{{"scb_golden", 1}, {"cases", cases}}.dump());
    }
    ProgramRun golden(const std::string& arguments, const Surroundings& surroundings = {}) const {
        return run_scb("golden " + arguments + " --suite " + suite, surroundings);
    }
    std::string baseline(const std::string& file) const {
        return file_text(folder.path / "my" / "baselines" / file);
    }

    const TemporaryFolder folder;
    const std::string suite = folder / "my/cases.json", models = folder / "models";
};

/// Two triangles that a third cuts; in the other order where `swapped`.
std::string two_triangles(bool swapped) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\n",
                      low = "f 1 2 3\n", high = "f 4 5 6\n";
    return vertices + (swapped ? high + low : low + high);
}

constexpr const char* cutting_triangle = "v 0.2 0.2 -0.5\nv 0.2 0.3 -0.5\nv 0.2 0.2 0.5\nf 1 2 3\n";

TEST_F(GoldenCommandCases, OfDistancesAllowTheStatedBound) {
    write_cases(
        {{{"name", "apart"}, {"run", "distance"}, {"scene", "spheres-l1"}, {"frames", "0"}}});
    ASSERT_EQ(golden("update --all").status, 0);
    const std::string file = folder / "my/baselines/apart.counts.json";
    const json kept = json::parse(file_text(file));
    const json& measured = kept["frames"]["0"]["distance"];
    const double distance = measured["value"], bound = measured["bound"];
    EXPECT_GT(distance, 0.05);
    EXPECT_GT(bound, 0);
    EXPECT_LT(bound, 1e-14);
    const auto check_with = [&](double value) {
        json other = kept;
        other["frames"]["0"]["distance"]["value"] = value;
        write_text(file, other.dump());
        return golden("check");
    };
    EXPECT_EQ(check_with(distance + bound / 2).status, 0);
    EXPECT_EQ(check_with(distance - bound / 2).status, 0);
    const double far = distance + 2 * bound;
    const ProgramRun run = check_with(far);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(
        run.out.find("spheres-l1, frame 0: expected the distance " + json(far).dump() + ", got " +
                     json(distance).dump() + "; they may differ by " + json(bound).dump() + "."),
        std::string::npos)
        << run.out;
    // Counts and triangles are exact.
    for (const char* place : {"/frames/0/n_v", "/frames/0/triangles/b", "/frames/0/stages/near"}) {
        json other = kept;
        json& count = other[json::json_pointer(place)];
        count = count.get<int>() + 1;
        write_text(file, other.dump());
        EXPECT_EQ(golden("check").status, 1) << place;
    }
    write_cases(
        {{{"name", "apart"}, {"run", "distance"}, {"scene", "spheres-l1"}, {"test", "corrected"}}});
    EXPECT_EQ(golden("check").status, 2);
}

TEST_F(GoldenCommandCases, AreOfOnePicture) {
    write_cases({{{"name", "two-levels"},
                  {"run", "levels"},
                  {"scene", "cone"},
                  {"arguments", {"--levels", "3,6"}}},
                 {{"name", "all-levels"}, {"run", "levels"}, {"scene", "cone"}}});
    const ProgramRun run = golden("check");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("two-levels: could not run. It draws 2 pictures, but a case has one"),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("`--levels`"), std::string::npos);
    EXPECT_NE(run.out.find("all-levels: could not run. It draws"), std::string::npos);
    EXPECT_EQ(golden("update --all").status, 1);
    EXPECT_EQ(baseline("two-levels.png"), "");
    write_cases(
        {{{"name", "several"}, {"run", "rejections"}, {"scene", "cone"}, {"frames", "100,110"}}});
    EXPECT_EQ(golden("check").status, 2);
    write_cases(
        {{{"name", "several"}, {"run", "levels"}, {"scene", "cone"}, {"volume", "scb,ball"}}});
    EXPECT_EQ(golden("check").status, 2);
}

TEST_F(GoldenCommandCases, FindOtherPairsThatAreAsMany) {
    write_text(folder / "my/a.obj", two_triangles(false));
    write_text(folder / "my/b.obj", cutting_triangle);
    write_cases({{{"name", "pair"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}}});
    ASSERT_EQ(golden("update --all").status, 0);
    EXPECT_EQ(golden("check").status, 0);
    write_text(folder / "my/a.obj", two_triangles(true));
    const ProgramRun run = golden("check");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("frames/0/pairs_hash"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("frames/0/pairs:"), std::string::npos) << run.out;
}

TEST_F(GoldenCommandCases, SayFirstWhichMeshIsAnother) {
    write_text(folder / "my/a.obj", two_triangles(false));
    write_text(folder / "my/b.obj", cutting_triangle);
    write_cases({{{"name", "front"},
                  {"run", "levels"},
                  {"scene", {"a.obj", "b.obj"}},
                  {"arguments", {"--levels", "0"}}},
                 {{"name", "pair"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}},
                 {{"name", "sum"}, {"run", "inspect"}, {"scene", {"a.obj", "b.obj"}}}});
    ASSERT_EQ(golden("update --all").status, 0);
    const std::string trace = folder / "my/baselines/pair.trace.scbrec";
    EXPECT_EQ(run_scb("inspect " + trace + " -o " + (folder / "out"), {folder / "my"}).status, 0);
    // As many triangles and vertices, elsewhere.
    std::string moved = two_triangles(true);
    moved.replace(moved.find("0 0 0"), 5, "3 0 0");
    write_text(folder / "my/a.obj", moved);
    const ProgramRun run = golden("check");
    for (const char* name : {"front", "pair", "sum"})
        EXPECT_TRUE(std::regex_search(
            run.out,
            std::regex(
                std::string(name) +
                ": different\\. The mesh of body a changed: as many triangles and vertices, but "
                "not the same\\. These differ: ")))
            << run.out;
    EXPECT_EQ(run.out.find("The mesh of body b"), std::string::npos);
    EXPECT_EQ(run.out.find(" moved"), std::string::npos);
    EXPECT_EQ(run.out.find("Another mesh of "), std::string::npos);
    const ProgramRun inspected =
        run_scb("inspect " + trace + " -o " + (folder / "out"), {folder / "my"});
    EXPECT_NE(
        inspected.err.find("with another mesh of a: it had 2 triangles and 6 vertices as that of "),
        std::string::npos)
        << inspected.err;
    EXPECT_NE(inspected.err.find("other coordinates or indices; record it again, or, where it is "
                                 "a baseline, see what `scb golden check` says."),
              std::string::npos)
        << inspected.err;
}

TEST_F(GoldenCommandCases, SayFirstWhichBodyMoved) {
    write_text(folder / "my/a.obj", two_triangles(false));
    write_text(folder / "my/b.obj", cutting_triangle);
    const auto write_pose = [&](const std::string& pose) {
        json cases;
        for (const char* run : {"levels", "rejections", "traversal", "inspect", "collide"})
            cases.push_back({{"name", run},
                             {"run", run},
                             {"scene", {"a.obj", "b.obj"}},
                             {"arguments", {"--pose=" + pose}}});
        cases[0]["arguments"].push_back("--levels=0");
        write_cases(cases);
    };
    write_pose("1,0,0,0,0,1,0,0,0,0,1,0");
    ASSERT_EQ(golden("update --all").status, 0);
    // A quarter turn, and up by half of the distance of the triangles.
    write_pose("0,-1,0,0,1,0,0,0,0,0,1,0.5");
    const ProgramRun run = golden("check");
    for (const char* name : {"levels", "rejections", "traversal", "inspect", "collide"})
        EXPECT_NE(run.out.find(std::string(name) +
                               ": different. Body b moved: 0.5 along z, 90 degrees. "),
                  std::string::npos)
            << run.out;
}

TEST_F(GoldenCommandCases, LeaveARecordingOfTheirNameInTheFolderOfTheBaselines) {
    const std::string recording = folder / "my/baselines/arm.scbrec";
    std::filesystem::create_directories(folder / "my/baselines");
    ASSERT_EQ(run_scb("trace cone --frames 100 --records -o " + recording).status, 0);
    write_cases({{{"name", "arm"}, {"run", "external"}, {"scene", "baselines/arm.scbrec"}}});
    const ProgramRun run = golden("update --all");
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_TRUE(std::filesystem::exists(recording)) << run.out;
}

TEST_F(GoldenCommandCases, OfOneFrameKeepATraceWhetherItIsNamedOrNot) {
    write_text(folder / "my/a.obj", two_triangles(false));
    write_text(folder / "my/b.obj", cutting_triangle);
    write_cases({{{"name", "unnamed"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}},
                 {{"name", "own"}, {"run", "pairs"}, {"scene", "cone"}},
                 {{"name", "many"}, {"run", "collide"}, {"scene", "cone"}, {"frames", "0,10"}}});
    ASSERT_EQ(golden("update --all").status, 0);
    EXPECT_NE(baseline("unnamed.trace.scbrec"), "");
    EXPECT_NE(baseline("own.trace.scbrec"), "");
    EXPECT_EQ(baseline("many.trace.scbrec"), "");
}

TEST_F(GoldenCommandCases, FindMeshesBesideTheSuiteThenAmongTheModels) {
    write_text(folder / "models/a.obj", two_triangles(false));
    write_text(folder / "models/b.obj", cutting_triangle);
    write_cases({{{"name", "pair"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}}});
    const ProgramRun none = golden("check");
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.out.find("pair: could not run. a.obj: there is no such file"), std::string::npos)
        << none.out;
    ASSERT_EQ(golden("update --all --models " + models).status, 0);
    EXPECT_EQ(golden("check --models " + models).status, 0);
    EXPECT_EQ(golden("check", {folder.path.string()}).status, 1);
    // A relative folder begins here, not where the suite is.
    EXPECT_EQ(golden("check --models models", {folder.path.string()}).status, 0);
    write_text(folder / "my/a.obj", two_triangles(true));
    EXPECT_EQ(golden("check --models " + models).status, 1);
}

TEST_F(GoldenCommandCases, TakeTheOptionBeforeTheEnvironment) {
    write_text(folder / "models/a.obj", two_triangles(false));
    write_text(folder / "models/b.obj", cutting_triangle);
    write_cases({{{"name", "pair"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}}});
    const auto check = [&](const std::string& environment, const std::string& option) {
        return run_scb("golden check --models " + option + " --suite " + suite,
                       {"", {"SCB_MODELS=" + environment}});
    };
    ASSERT_EQ(golden("update --all --models " + models).status, 0);
    EXPECT_EQ(check("/nonexistent", models).status, 0);
    const ProgramRun run = check(models, "/nonexistent");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("nor is there /nonexistent/a.obj"), std::string::npos) << run.out;
    EXPECT_EQ(run_scb("golden check --suite " + suite, {"", {"SCB_MODELS=" + models}}).status, 0);
}

TEST_F(GoldenCommandCases, GiveTheSameBaselinesFromAnyFolder) {
    write_text(folder / "my/a.obj", two_triangles(false));
    write_text(folder / "my/b.obj", cutting_triangle);
    write_text(folder / "my/scene.json", R"({
      "scb_scene": 1, "name": "two", "frames": 3,
      "models": [{"name": "a", "file": "a.obj"}, {"name": "b", "file": "b.obj"}],
      "bodies": [{"name": "left", "model": "a"}, {"name": "right", "model": "b"}]
    })");
    write_cases({{{"name", "meshes"}, {"run", "collide"}, {"scene", {"a.obj", "b.obj"}}},
                 {{"name", "scene"}, {"run", "pairs"}, {"scene", "scene.json"}, {"frames", "1"}}});
    ASSERT_EQ(golden("update --all").status, 0);
    for (const char* file : {"meshes.meta.json", "scene.meta.json", "scene.trace.scbrec"}) {
        EXPECT_NE(baseline(file), "") << file;
        EXPECT_EQ(baseline(file).find(folder.path.string()), std::string::npos) << file;
    }
    const std::string here = folder.path.string();
    for (const std::string& from : {here, folder / "my", std::string("/")})
        EXPECT_EQ(run_scb("golden update --all --suite " + suite, {from}).out,
                  "0 of 2 cases updated\n")
            << from;
    EXPECT_EQ(run_scb("golden update --all --suite my/cases.json", {here}).out,
              "0 of 2 cases updated\n");
    EXPECT_EQ(run_scb("golden check --suite cases.json", {folder / "my"}).out, "2 cases: 2 same\n");
}

TEST_F(GoldenCommandCases, AFolderIsNoBaseline) {
    write_cases({{{"name", "front"}, {"run", "pairs"}, {"scene", "cone"}}});
    ASSERT_EQ(golden("update --all").status, 0);
    EXPECT_EQ(golden("list").out.find("MISSING"), std::string::npos);
    fs::remove(folder.path / "my" / "baselines" / "front.png");
    fs::create_directory(folder.path / "my" / "baselines" / "front.png");
    EXPECT_NE(golden("list").out.find("MISSING"), std::string::npos);
    EXPECT_NE(golden("check").out.find("new output"), std::string::npos);
}

TEST_F(GoldenCommandCases, AreAskedForNoMoreThanTheyCompare) {
    write_cases({{{"name", "counts"},
                  {"run", "collide"},
                  {"scene", "spheres-l1"},
                  {"frames", "0:499:10"}}});
    ASSERT_EQ(golden("update --all").status, 0);
    const ProgramRun run = golden("selftest");
    EXPECT_EQ(run.status, 0) << run.out;
    EXPECT_NE(run.out.find("ids     not compared"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("NOT CAUGHT"), std::string::npos) << run.out;
}

TEST_F(GoldenCommandCases, ThatCrashCatchNothing) {
    write_cases({{{"name", "levels"},
                  {"run", "levels"},
                  {"scene", "spheres-l1"},
                  {"arguments", {"--levels", "5"}}}});
    ASSERT_EQ(golden("update --all").status, 0);
    const std::string runner = folder / "runner";
    write_text(runner, "#!/bin/sh\ncase \"$*\" in *--mutation*) exit 2;; esac\nexec \"$@\"\n");
    fs::permissions(runner, fs::perms::owner_all);
    const ProgramRun run = golden("selftest --runner " + runner);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("nudge-radius     caught by 0 of 1 cases: NOT CAUGHT by ids, colors\n"),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("    could not run 1: levels\n"), std::string::npos) << run.out;
}

TEST_F(GoldenCommandCases, SayHowTheirRunnerEnded) {
    write_cases({{{"name", "front"}, {"run", "pairs"}, {"scene", "cone"}},
                 {{"name", "summary"}, {"run", "inspect"}, {"scene", "cone"}},
                 {{"name", "counts"}, {"run", "collide"}, {"scene", "cone"}}});
    const ProgramRun failed = golden("check --runner false"), idle = golden("check --runner true");
    EXPECT_NE(failed.out.find("front: could not run. It ended with status 1.\n"), std::string::npos)
        << failed.out;
    EXPECT_NE(failed.out.find("counts: could not run. It ended with status 1.\n"),
              std::string::npos);
    // Status 1 of `inspect` is a finding, not an error. The missing index.json is the error.
    EXPECT_NE(failed.out.find(
                  "summary: could not run. It ended with status 1 and has made no index.json.\n"),
              std::string::npos)
        << failed.out;
    EXPECT_NE(
        idle.out.find("front: could not run. It ended with status 0 and has made no index.json.\n"),
        std::string::npos)
        << idle.out;
}

TEST_F(GoldenCommandCases, NeedASuiteAndRoom) {
    const ProgramRun none = run_scb("golden check", {"/"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("there is no such file; name your suite with --suite"),
              std::string::npos)
        << none.err;
    write_cases({{{"name", "front"}, {"run", "pairs"}, {"scene", "cone"}}});
    const ProgramRun roomless = golden("check", {"", {"TMPDIR=" + suite}});
    EXPECT_EQ(roomless.status, 3);
    EXPECT_NE(roomless.err.find("There is no folder for temporary files (Not a directory)"),
              std::string::npos)
        << roomless.err;
}

TEST_F(GoldenCommandCases, ThatCatchNothingAreToldWhatWould) {
    write_cases({{{"name", "top"},
                  {"run", "levels"},
                  {"scene", "spheres-l1"},
                  {"arguments", {"--levels", "2"}},
                  {"compare", {"ids"}}}});
    ASSERT_EQ(golden("update --all").status, 0);
    const ProgramRun run = golden("selftest");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("nudge-radius     caught by 0 of 1 cases: NOT CAUGHT by ids\n"),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("add a case of `levels --levels 5` that compares ids."),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("shift-color      caught by 0 of 1 cases\n"), std::string::npos)
        << run.out;
}

}  // namespace
}  // namespace scb::app
