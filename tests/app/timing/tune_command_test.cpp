#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "render/files/image_file.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json tune(const std::string& arguments) {
    const ProgramRun run = run_scb("tune --json " + arguments);
    EXPECT_EQ(run.status, 0) << arguments << run.err;
    return json::parse(run.out);
}

/// What `scb collide` is to be asked for the same.
std::string options_of(const json& setting) {
    std::string options = " --test " + setting["test"].get<std::string>() + " --descent " +
                          setting["descent"].get<std::string>() + " --growth " +
                          setting["growth"].get<std::string>();
    if (setting.contains("threshold")) options += " --threshold " + setting["threshold"].dump();
    return options;
}

TEST(TuneCommand, HasTheCountsOfCollide) {
    const json found = tune("spheres-l1 --frames 60,250 --no-time");
    ASSERT_GE(found["settings"].size(), 27u);
    EXPECT_EQ(found["frames"], json({60, 250}));
    std::size_t missing = 0;
    for (const json& setting : found["settings"]) {
        const std::string arguments = "collide spheres-l1 --json --frames 60,250";
        const json mean = json::parse(run_scb(arguments + options_of(setting)).out)["mean"];
        for (const char* count : {"n_v", "n_p", "pairs"})
            EXPECT_EQ(setting[count], mean[count]) << options_of(setting) << " " << count;
        EXPECT_FALSE(setting.contains("ms"));
        EXPECT_EQ(setting["misses_pairs"], setting["test"] == "printed");
        missing += setting["misses_pairs"].get<bool>();
    }
    EXPECT_EQ(missing, 1u);
}

TEST(TuneCommand, HasTheOperationsOfInspect) {
    const json found = tune("knots-l1 --frames 0 --no-time");
    const json work = json::parse(run_scb("inspect knots-l1 --frames 0 --json").out)["sum"]["work"];
    EXPECT_EQ(found["settings"][0]["operations"], work["operations"]);
}

TEST(TuneCommand, TheBestHasTheFewestOperations) {
    const json found = tune("spheres-l1 --frames 60,250 --no-time");
    const std::size_t best = found["best"]["operations"];
    EXPECT_FALSE(found["best"].contains("time"));
    for (const json& setting : found["settings"])
        if (setting["test"] != "printed") {
            EXPECT_LE(found["settings"][best]["operations"], setting["operations"]);
        }
    EXPECT_EQ(found["settings"].front()["tuned"], "base");
    EXPECT_EQ(found["settings"].back()["tuned"], "best");
}

TEST(TuneCommand, TheBaseIsWhatWasAsked) {
    const json found = tune(
        "cone --frames 80 --no-time --test line8 --threshold 0.33 --descent area --growth radius "
        "--margin 0.01");
    const json base = found["settings"][0];
    EXPECT_EQ(base["test"], "line8");
    EXPECT_EQ(base["threshold"], 0.33);
    EXPECT_EQ(base["descent"], "area");
    EXPECT_EQ(base["growth"], "radius");
    const json mean = json::parse(
        run_scb("collide cone --frames 80 --json --margin 0.01" + options_of(base)).out)["mean"];
    EXPECT_EQ(base["n_v"], mean["n_v"]);
}

TEST(TuneCommand, TakesEveryVolume) {
    const TemporaryFolder folder;
    for (const char* volume : {"scb2", "ball", "ritter", "obb"}) {
        const std::string asked = " --frames 80 --margin 0.1 --volume " + std::string(volume);
        const json found = tune("cone --no-time --size 640x480 -o " + folder.path.string() + asked);
        EXPECT_EQ(found["volume"], volume);
        ASSERT_GE(found["settings"].size(), 2u);
        for (const json& setting : found["settings"]) {
            EXPECT_FALSE(setting.contains("test"));
            const std::string growth = setting.contains("growth")
                                           ? " --growth " + setting["growth"].get<std::string>()
                                           : "";
            const ProgramRun run = run_scb("collide cone --json" + asked + growth + " --descent " +
                                           setting["descent"].get<std::string>());
            const json mean = json::parse(run.out)["mean"];
            for (const char* count : {"n_v", "n_p", "pairs"})
                EXPECT_EQ(setting[count], mean[count]) << volume << setting;
        }
        EXPECT_EQ(lines_of(file_text(folder.path / "tune.csv")), 1 + found["settings"].size());
    }
    const ProgramRun run = run_scb("tune cone --frames 80 --no-time --volume scb2 --threshold 0.3");
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("--threshold has no effect"), std::string::npos) << run.err;
}

TEST(TuneCommand, WithoutTimesIsTheSameEachTime) {
    const TemporaryFolder folder;
    const std::string arguments = "tune cone --frames 0:199:40 --no-time -o ";
    const ProgramRun first = run_scb(arguments + (folder / "a")),
                     second = run_scb(arguments + (folder / "b"));
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(first.out, second.out);
    EXPECT_EQ(first.out.find("ms"), std::string::npos);
    for (const char* file : {"tune.csv", "tune.json", "cone_tune.png"})
        EXPECT_EQ(file_text(folder.path / "a" / file), file_text(folder.path / "b" / file)) << file;
}

TEST(TuneCommand, TimesEverySettingAndWritesFiles) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const json found = tune("cone --frames 60,80 --repeat 1 --size 640x480 -o " + out);
    for (const json& setting : found["settings"]) EXPECT_GT(setting["ms"], 0);
    EXPECT_LT(found["best"]["time"], found["settings"].size());
    EXPECT_EQ(json::parse(file_text(fs::path(out) / "tune.json")), found);
    EXPECT_EQ(lines_of(file_text(fs::path(out) / "tune.csv")), 1 + found["settings"].size());
    const render::Image picture = render::read_png(fs::path(out) / "cone_tune.png");
    EXPECT_EQ(picture.width, 640);
    EXPECT_EQ(picture.height, 480);
    const std::string table = run_scb("tune cone --frames 60 --repeat 1").out;
    for (const char* part : {"Fewest operations: ", "Least time: ", "descent alternating",
                             "corrected a=0.95", "growth radius"})
        EXPECT_NE(table.find(part), std::string::npos) << part;
}

TEST(TuneCommand, TakesAFewFramesOfALongScene) {
    const json found = tune("cone --no-time");
    EXPECT_EQ(found["frames"].size(), 50u);
    EXPECT_EQ(found["frames"][1], 4);
}

TEST(TuneCommand, EndsWhenInterrupted) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("endless.json", endless_scene);
    const ProgramRun run =
        run_scb("tune " + scene + " --frames all --quiet -o " + (folder / "out") +
                " & child=$!; sleep 1; kill -TERM $child; wait $child");
    EXPECT_EQ(run.status, 143) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_FALSE(fs::exists(folder / "out/tune.json"));
}

TEST(TuneCommand, ReplacesNothingThatTheSceneWasReadFrom) {
    const TemporaryFolder folder;
    const std::string scene = folder / "tune.json", text = run_scb("scenes cone").out;
    write_text(scene, text);
    const ProgramRun run =
        run_scb("tune " + scene + " --frames 1 --no-time -o " + folder.path.string());
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(file_text(scene), text);
}

TEST(TuneCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    const std::string mesh = folder / "level.ply";
    ASSERT_EQ(run_scb("export spheres-l1 --level 3 -o " + mesh).status, 0);
    for (const auto& [arguments, said] :
         {std::pair<std::string, std::string>{"cone --frames 200", "0 to 199"},
          {"cone --frames 5:3", "--frames"},
          {mesh, "has one body"},
          {"cone --bodies A,C", "not a body"},
          {"cone --volume scb,ball", "one"},
          {"cone --test nonsense", "not an overlap test"},
          {"cone --test corrected,extents", "one overlap test"},
          {"cone --threshold 1.5", "0 to 1"},
          {"cone --descent nonsense", "give radius, area, volume or alternating"},
          {"cone --growth nonsense", "give radius or ritter"},
          {"cone --repeat 0", "1 to 1000"},
          {"cone --size 10x10 -o out", "--size"},
          {"nonsense", "nonsense"}}) {
        const ProgramRun run = run_scb("tune " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_NE(run.err.find(said), std::string::npos) << arguments << ": " << run.err;
    }
    EXPECT_FALSE(fs::exists("out"));
}

}  // namespace
}  // namespace scb::app
