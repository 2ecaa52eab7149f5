#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "core/base/text_format.h"
#include "tests/app/inspect/inspect_run.h"

namespace scb::app {
namespace {

using nlohmann::json;

TEST(InspectAdvice, NamesTheSettingThatWouldHaveHelpedMost) {
    const std::string asked = "long-triangles --frames 0,120";
    const json found = inspect(asked), settings = found["settings"]["settings"];
    EXPECT_EQ(found["settings"]["frames"], json({0, 120}));
    const json best = settings[found["settings"]["best"]["cost"].get<std::size_t>()];
    for (const json& setting : settings)
        if (!setting["misses_pairs"]) {
            EXPECT_LE(best["cost"], setting["cost"]);
        }
    EXPECT_EQ(settings[0]["n_v"].get<double>() * 2, found["sum"]["n_v"].get<double>());
    const std::string command = found["settings"]["command"];
    EXPECT_NE(command.find("scb collide long-triangles --frames 0,120 --volume "),
              std::string::npos)
        << command;
    const json mean = json::parse(run_scb(command.substr(4) + " --json").out)["mean"];
    EXPECT_EQ(mean["n_v"], best["n_v"]);
    // The text begins with it and the command.
    const std::string text = run_scb("inspect " + asked).out,
                      title = text.substr(0, text.find('\n') + 2);
    EXPECT_EQ(text.find("Best of "), title.size()) << text;
    // A single test of two capsules costs less than any packed query.
    EXPECT_LT(text.find("\n  " + command + "\n"), text.find("volume tests")) << text;
    const std::string full = run_scb("inspect --full " + asked).out;
    EXPECT_NE(full.find(" of the cost of the present setting ("), std::string::npos) << full;
    const std::string code = "C++: scb::build_hierarchy<scb::Capsule>(mesh)\n";
    EXPECT_TRUE(full.ends_with("To use it: " + command + "\n  in " + code)) << full;
    EXPECT_NE(text.find("\n  " + code), std::string::npos) << text;
    for (const char* part : {"\ntriangles in the most tests; N_v: ",
                             "\nframes, the most wasted N_v first\nframe    pairs"}) {
        EXPECT_NE(full.find(part), std::string::npos) << full;
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
    EXPECT_NE(text.find("settings over 2 frames: "), std::string::npos) << text;
    EXPECT_NE(text.find(" are slender"), std::string::npos) << text;
}

TEST(InspectAdvice, FitsOnAScreen) {
    std::string many = "cone --frames 60";
    for (int frame = 61; frame < 100; ++frame) many += "," + std::to_string(frame);
    for (const std::string& queries : {std::string("spheres-l1 --frames 0:499:100"),
                                       std::string("knots-l1 --frames 0,200"), many}) {
        const std::string out = run_scb("inspect " + queries).out;
        EXPECT_EQ(out.find(",\\\n") != std::string::npos, queries == many) << out;
        std::istringstream text(out);
        std::string line, last;
        std::size_t lines = 0;
        while (std::getline(text, line)) {
            last = line;
            // A line of a list that goes on is no line of its own.
            lines += !line.ends_with(",\\");
            if (!line.starts_with("  C++: ")) {
                EXPECT_LE(character_count(line), 100u) << line;
            }
        }
        EXPECT_LE(lines, 40u);
        EXPECT_EQ(last, "--full prints all tables.");
    }
}

TEST(InspectAdvice, ListsTheTrianglesInTheMostTests) {
    const std::string asked = "long-triangles --frames 0:199:20";
    const json found = inspect(asked);
    ASSERT_FALSE(found["triangles"].empty());
    std::map<std::string, std::uint64_t> tests;
    for (const json& one : found["triangles"]) {
        const std::string body = one["body"];
        EXPECT_LE(one["n_p"], tests.try_emplace(body, UINT64_MAX).first->second);
        tests[body] = one["n_p"];
        EXPECT_NEAR(one["share"].get<double>(),
                    one["n_p"].get<double>() / found["sum"]["n_p"].get<double>(), 1e-12);
        EXPECT_GT(one["n_v"], 0u);
        EXPECT_GT(one["longest_side"], 0);
    }
    EXPECT_EQ(tests.size(), 2u);
}

TEST(InspectAdvice, CutsLongTrianglesIfThatLowersTheCost) {
    const TemporaryFolder folder;
    const std::string file = folder.write("disc.json", R"({"scb_scene": 1, "name": "disc",
        "frames": 5, "models": [{"name": "disc", "cone": {"radius": 5, "height": 1, "sides": 120}},
        {"name": "ball", "icosphere": {"subdivisions": 5, "radius": 0.4}}],
        "bodies": [{"name": "disc", "model": "disc"}, {"name": "ball", "model": "ball",
        "position": {"from": [-3, 0.1, 0.02], "to": [3, 0.2, 0.1], "frames": 5},
        "rotation": [{"axis": [1, 2, 3], "per_frame": 7}]}]})");
    const json found = inspect(file + " --frames all");
    ASSERT_TRUE(found["settings"].contains("cuts")) << found["settings"];
    const json cuts = found["settings"]["cuts"], mesh = cuts["meshes"][0];
    EXPECT_EQ(mesh["body"], "disc");
    EXPECT_LT(cuts["after"]["cost"].get<double>(), 0.9 * cuts["before"]["cost"].get<double>());
    // The command writes a mesh with these pieces.
    std::string command = mesh["command"];
    const std::string cut = folder / "disc-cut.ply";
    command.replace(command.find("disc-cut.ply"), std::string("disc-cut.ply").size(), cut);
    const ProgramRun written = run_scb(command.substr(4) + " --map " + folder / "map.csv");
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_NE(written.err.find("; " + std::to_string(mesh["triangles"].get<int>()) +
                               " triangles cut into " +
                               count_text(mesh["pieces"].get<std::uint64_t>()) + " pieces."),
              std::string::npos)
        << written.err;
    EXPECT_TRUE(file_text(folder / "map.csv").starts_with("triangle,cut_from\n0,0\n1,1\n"));
}

/// A ball as an OBJ file. `twice`: each triangle is there twice.
std::string ball_file(const TemporaryFolder& folder, const std::string& name, bool twice) {
    const int rings = 24, sides = 48;
    std::string text;
    const double pi = std::acos(-1.0);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sides; ++j) {
            const double u = pi * i / rings, v = 2 * pi * j / sides;
            text += format("v %.9g %.9g %.9g\n", std::sin(u) * std::cos(v),
                           std::sin(u) * std::sin(v), std::cos(u));
        }
    for (int copy = 0; copy < (twice ? 2 : 1); ++copy)
        for (int i = 0; i < rings; ++i)
            for (int j = 0; j < sides; ++j) {
                const int next = (j + 1) % sides, a = 1 + sides * i, b = a + sides;
                if (i > 0) text += format("f %d %d %d\n", a + j, b + j, a + next);
                if (i + 1 < rings) text += format("f %d %d %d\n", a + next, b + j, b + next);
            }
    return folder.write(name, text);
}

TEST(InspectAdvice, LeavesOutCopiesIfThatLowersTheCost) {
    const TemporaryFolder folder;
    const std::string twice = ball_file(folder, "twice.obj", true),
                      once = ball_file(folder, "once.obj", false),
                      pose = " --pose=1,0,0,0.7,0,1,0,0.1,0,0,1,0.2";
    const json found = inspect(twice + " " + once + pose);
    ASSERT_TRUE(found["settings"].contains("clean")) << found["settings"].dump().substr(0, 999);
    const json cure = found["settings"]["clean"], mesh = cure["meshes"][0];
    EXPECT_EQ(cure["meshes"].size(), 1u);
    EXPECT_EQ(mesh["body"], "twice");
    EXPECT_EQ(mesh["copies"], 2208);
    EXPECT_EQ(mesh["degenerate"], 0);
    // The command writes the mesh, and its queries have the work of the trial.
    std::string command = mesh["command"];
    const std::string clean = folder / "clean.ply";
    command.replace(command.find("twice-clean.ply"), std::string("twice-clean.ply").size(), clean);
    const ProgramRun written = run_scb(command.substr(4) + " --map " + folder / "map.csv");
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_NE(written.err.find("2,208 copies and 0 triangles without area left out."),
              std::string::npos)
        << written.err;
    const json counts =
        json::parse(run_scb("collide " + clean + " " + once + pose + " --json").out);
    EXPECT_NEAR(counts["mean"]["n_v"].get<double>(), cure["base"]["after"]["n_v"].get<double>(),
                0.01 * counts["mean"]["n_v"].get<double>());
    EXPECT_FALSE(inspect(once + " " + once + pose)["settings"].contains("clean"));
}

TEST(InspectAdvice, SaysHowTheTriangleTestsOfTouchingPartsAreDecided) {
    const json found = inspect("stack --frames 0");
    const auto layout = found["settings"]["best"]["layout"].get<std::size_t>();
    const json packed = found["settings"]["layouts"][layout];
    const double all = packed["n_p"], exact = packed["n_exact"], left = packed["n_after_doubles"];
    EXPECT_GT(all, exact);
    EXPECT_GT(exact, left);
    EXPECT_GT(left, 0);
    const std::string words = format(
        "%.1f %% of the triangle tests are decided in floats, %.1f %% in "
        "doubles, and %.1f %% exactly",
        100 * (1 - exact / all), 100 * (exact - left) / all, 100 * left / all);
    std::string text = run_scb("inspect stack --frames 0").out;
    for (std::size_t at = 0; (at = text.find("\n  ", at)) != text.npos;) text.replace(at, 3, " ");
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    // Triangles that only cross are decided in floats.
    EXPECT_EQ(run_scb("inspect spheres-l1 --frames 100").out.find("decided in floats"),
              std::string::npos);
}

TEST(InspectAdvice, NamesTheLineOfCodeThatBuildsTheBestLayout) {
    const auto code = [](const std::string& asked) {
        const std::string text = run_scb("inspect " + asked).out, words = "\n  C++: ";
        const std::size_t at = text.find(words);
        EXPECT_NE(at, std::string::npos) << text;
        return text.substr(at + words.size(), text.find('\n', at + 1) - at - words.size());
    };
    EXPECT_EQ(code("spheres-l1 --frames 100"),
              "scb::build_packed<scb::QuantizedCodec<8, scb::Scb2>>(mesh)");
    EXPECT_EQ(code("spheres-l1 --frames 100 --margin 0.25")
                  .find("(mesh, {.fit = {.margin = 0.25}, .split = scb::SplitMethod::cost})"),
              std::string("scb::build_packed<scb::QuantizedCodec<8>>").size());
}

TEST(InspectAdvice, GivesUpSettingsThatCostFarMoreAndNamesTheSameBest) {
    // In the second, queries of many frames end at the roots, and others take many tests.
    for (const std::string queries :
         {" knots-l1 --frames 0:499:100", " long-triangles --volume obb --frames 0:199:20"}) {
        const json found = inspect(queries.substr(1))["settings"],
                   all = json::parse(run_scb("tune" + queries + " --no-time --json").out);
        const json& counted = all.is_array() ? all[0] : all;
        const auto best = [](const json& tuning) {
            return tuning["settings"][tuning["best"]["cost"].get<std::size_t>()];
        };
        EXPECT_EQ(best(found), best(counted)) << queries;
        const auto given_up = found["given_up"].get<std::size_t>();
        EXPECT_GT(given_up, 0u);
        EXPECT_LT(found["settings"].size(), counted["settings"].size());
        // The volumes and splits that are missing cost over three times the least.
        const double least = best(counted)["cost"];
        const json& kept = found["settings"];
        for (const json& setting : counted["settings"])
            if (setting["cost"].get<double>() <= 3 * least &&
                (setting["tuned"] == "volume" || setting["tuned"] == "split")) {
                EXPECT_NE(std::find(kept.begin(), kept.end(), setting), kept.end()) << setting;
            }
        EXPECT_NE(run_scb("inspect --full" + queries)
                      .out.find("\n" + std::to_string(given_up) + " of " +
                                std::to_string(given_up + found["settings"].size()) +
                                " settings were given up: they cost over 3 times the least before "
                                "them.\n"),
                  std::string::npos);
    }
}

// The test `printed` rejects the roots of a ball inside a ball, and costs next to nothing.
TEST(InspectAdvice, MeasuresSettingsAgainstTestsThatMissNoPairs) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("balls.json",
                     R"({"scb_scene": 1, "name": "balls", "frames": 3, "models": [
            {"name": "small", "icosphere": {"subdivisions": 3, "radius": 0.1}},
            {"name": "large", "icosphere": {"subdivisions": 3, "radius": 1}}],
            "bodies": [{"name": "A", "model": "large"},
            {"name": "B", "model": "small", "position": [0.8, 0.01, 0.02]}]})");
    const ProgramRun run = run_scb("inspect " + file + " --test printed --frames 0:2 --json");
    EXPECT_EQ(run.status, 1) << run.err;
    const json found = json::parse(run.out)["settings"];
    EXPECT_GT(found["settings"].size(), 10u);
    const json best = found["settings"][found["best"]["cost"].get<std::size_t>()],
               all = json::parse(
                   run_scb("tune " + file + " --test printed --frames 0:2 --no-time --json").out),
               counted = all.is_array() ? all[0] : all;
    EXPECT_EQ(best, counted["settings"][counted["best"]["cost"].get<std::size_t>()]);
}

TEST(InspectAdvice, NeedsAHundredTests) {
    for (const char* more : {"", " --full"}) {
        const std::string text = run_scb(std::string("inspect spheres-l1 --frame 0") + more).out;
        EXPECT_NE(text.find("\nToo few tests to advise: 1 volume test.\n"), std::string::npos);
        for (const char* advice : {"Best of ", "scb collide", "C++"})
            EXPECT_EQ(text.find(advice), std::string::npos) << text;
    }
}

TEST(InspectAdvice, NamesTheFrameOfItsCounts) {
    const std::string text = run_scb("inspect spheres-l1 --frames 100").out;
    EXPECT_NE(text.find(" in frame 100: "), std::string::npos) << text;
}

TEST(InspectAdvice, DoesNotTakeNeighborsForWaste) {
    const TemporaryFolder folder;
    const json found = inspect(folder.write("ball.json",
                                            R"({"scb_scene": 1, "name": "ball", "models": [
        {"name": "ball", "icosphere": {"subdivisions": 2}}],
        "bodies": [{"name": "ball", "model": "ball"}]})") +
                               " --bodies ball,ball --no-advice"),
               sum = found["sum"];
    EXPECT_EQ(sum["pairs"], 0u);
    EXPECT_GT(sum["leaves"]["true"], 100u) << sum;
    EXPECT_LT(sum["wasted"]["n_v"].get<double>(), 0.8 * sum["n_v"].get<double>()) << sum;
}

TEST(InspectAdvice, TriesNoSettingsIfNoAdviceIsAskedFor) {
    const json without = inspect("knots-l1 --frames 0 --no-advice");
    EXPECT_FALSE(without.contains("settings"));
    EXPECT_TRUE(inspect("knots-l1 --frames 0").contains("settings"));
    const std::string text = run_scb("inspect knots-l1 --frames 0 --no-advice").out;
    EXPECT_EQ(text.find("Best of "), std::string::npos) << text;
    EXPECT_NE(run_scb("inspect knots-l1 --frames 0 --no-advice --time")
                  .err.find("--time has no effect with --no-advice"),
              std::string::npos);
}

TEST(InspectAdvice, HasNoSettingsOfPartsOfQueries) {
    for (const char* options : {"--max-pairs 5", "--levels 6"})
        EXPECT_FALSE(
            inspect("spheres-l1 --frames 100 " + std::string(options)).contains("settings"))
            << options;
}

}  // namespace
}  // namespace scb::app
