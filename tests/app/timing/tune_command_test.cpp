#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

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
    std::string options;
    for (const char* option :
         {"volume", "split", "test", "threshold", "descent", "growth", "layout"})
        if (setting.contains(option))
            options += " --" + std::string(option) + " " +
                       (setting[option].is_string() ? setting[option].get<std::string>()
                                                    : setting[option].dump());
    return options;
}

std::size_t lines_of_csv(const json& found) {
    return 1 + found["settings"].size() + found["layouts"].size();
}

TEST(TuneCommand, LayoutsHaveTheCountsAndMemoryOfBench) {
    const json found = tune("cone --frames 60,100 --no-time");
    std::map<std::string, std::size_t> volumes;
    for (const json& layout : found["layouts"]) {
        const json bench =
            json::parse(run_scb("bench cone --json --repeat 1 --frames 60,100 --leaf " +
                                layout["leaf"].dump() + options_of(layout))
                            .out)["scenes"][0]["hierarchies"][0];
        for (const char* field : {"n_v", "n_p", "pairs", "bytes_per_triangle"})
            EXPECT_EQ(layout[field], bench[field]) << layout << field;
        const json& unpacked = found["settings"][layout["setting"].get<std::size_t>()];
        for (const char* field : {"volume", "split", "growth", "pairs"})
            EXPECT_EQ(layout[field], unpacked[field]) << layout << field;
        EXPECT_LT(layout["bytes_per_triangle"], unpacked["bytes_per_triangle"]);
        EXPECT_FALSE(layout["misses_pairs"]);
        EXPECT_FALSE(layout.contains("ms") || layout.contains("build_ms"));
        ++volumes[layout["volume"]];
    }
    EXPECT_EQ(volumes, (std::map<std::string, std::size_t>{{"scb", 12}, {"scb2", 12}}));
    // Without times, the layout is one that costs less than any setting unpacked.
    const json& chosen = found["layouts"][found["best"]["layout"].get<std::size_t>()];
    EXPECT_LT(chosen["cost"], found["settings"][found["best"]["cost"].get<std::size_t>()]["cost"]);
    for (const json& layout : found["layouts"])
        EXPECT_TRUE(!layout["layout"].get<std::string>().ends_with("8") || layout["leaf"] != 4 ||
                    chosen["cost"].get<double>() <= 1.1 * layout["cost"].get<double>())
            << layout;
}

// Which one that is depends on the machine; how it is chosen is tested with
// QuickestWithLeastMemory.
TEST(TuneCommand, NamesACommandForTheLayoutThatIsMeasurablyQuicker) {
    const json found = tune("spheres-l1 --frames 100,250");
    ASSERT_EQ(found["best"].contains("layout"), found.contains("layout_command"));
    for (const json& layout : found["layouts"]) EXPECT_LE(layout["ms_least"], layout["ms_most"]);
    if (!found.contains("layout_command")) return;
    const json& layout = found["layouts"][found["best"]["layout"].get<std::size_t>()];
    const json& plain = found["settings"][found["best"]["time"].get<std::size_t>()];
    EXPECT_LT(layout["ms_most"], plain["ms_least"]);
    const std::string command = found["layout_command"];
    EXPECT_NE(command.find("scb collide spheres-l1 --frames 100,250 --volume " +
                           layout["volume"].get<std::string>()),
              std::string::npos)
        << command;
    EXPECT_EQ(run_scb(command.substr(4)).status, 0) << command;
}

TEST(TuneCommand, SaysWhyThereAreNoLayouts) {
    const TemporaryFolder folder;
    const std::string far =
        folder.write("far.off", "OFF\n3 1 0\n1e9 0 0\n1e9 1 0\n1e9 0 1\n3 0 1 2\n");
    const ProgramRun run = run_scb("tune " + far + " " + far + " --no-time");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("No packed layout was tried: "), std::string::npos) << run.out;
}

TEST(TuneCommand, HasTheCountsOfCollide) {
    const json found = tune("cone --frames 60,100 --no-time");
    ASSERT_GE(found["settings"].size(), 40u);
    EXPECT_EQ(found["frames"], json({60, 100}));
    std::set<std::string> volumes;
    std::size_t missing = 0;
    for (const json& setting : found["settings"]) {
        const std::string arguments = "collide cone --json --frames 60,100";
        const json mean = json::parse(run_scb(arguments + options_of(setting)).out)["mean"];
        for (const char* count : {"n_v", "n_p", "pairs"})
            EXPECT_EQ(setting[count], mean[count]) << options_of(setting) << " " << count;
        EXPECT_FALSE(setting.contains("ms") || setting.contains("build_ms"));
        volumes.insert(setting["volume"].get<std::string>() + setting["split"].get<std::string>());
        missing += setting["misses_pairs"].get<bool>();
    }
    EXPECT_EQ(volumes.size(), 24u);
    EXPECT_LE(missing, 1u);
}

TEST(TuneCommand, HasTheBytesOfStats) {
    const json found = tune("soup --frames 60 --no-time"),
               stats = json::parse(run_scb("stats soup --json").out)["hierarchies"][0];
    EXPECT_EQ(found["settings"][0]["bytes_per_triangle"], stats["bytes_per_triangle"]);
}

TEST(TuneCommand, HasTheOperationsOfInspect) {
    const json found = tune("knots-l1 --frames 0 --no-time");
    const json work = json::parse(run_scb("inspect knots-l1 --frames 0 --json").out)["sum"]["work"];
    EXPECT_EQ(found["settings"][0]["operations"], work["operations"]);
}

/// The least N_v and operations of the settings that find all pairs.
json least_of(const json& found, const char* count) {
    json least;
    for (const json& setting : found["settings"])
        if (!setting["misses_pairs"] && setting.value("test", "") != "printed" &&
            (least.is_null() || setting[count] < least))
            least = setting[count];
    return least;
}

TEST(TuneCommand, TheBestCostsLeast) {
    const json found = tune("spheres-l1 --frames 60,250 --no-time");
    const json &settings = found["settings"], &best = found["best"];
    EXPECT_FALSE(best.contains("time"));
    EXPECT_EQ(settings[best["tests"].get<std::size_t>()]["n_v"], least_of(found, "n_v"));
    EXPECT_EQ(settings[best["operations"].get<std::size_t>()]["operations"],
              least_of(found, "operations"));
    EXPECT_EQ(settings[best["cost"].get<std::size_t>()]["cost"], least_of(found, "cost"));
    EXPECT_EQ(best["recommended"], best["cost"]);
    EXPECT_EQ(settings.front()["tuned"], "base");
    EXPECT_EQ(found["best_first"][0], best["cost"]);
    json last = 0;
    for (const std::size_t place : found["best_first"]) {
        EXPECT_GE(settings[place]["cost"], last);
        last = settings[place]["cost"];
    }
}

/// The lines that end with that mark.
std::vector<std::string> marked_lines(const std::string& text, const std::string& mark) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (line.ends_with(mark)) lines.push_back(line);
    return lines;
}

TEST(TuneCommand, AgreesWithInspectAndMarksTheRow) {
    for (const char* asked : {"cone --frames 80", "soup --frames 60", "long-triangles --frames 120",
                              "spheres-l1 --frames 100 --volume obb"}) {
        const std::string query(asked), tuned = run_scb("tune " + query + " --no-time").out,
                                        inspected = run_scb("inspect --full " + query).out;
        const auto use = [](const std::string& text) {
            return text.substr(text.rfind("To use it: "));
        };
        EXPECT_EQ(use(tuned), use(inspected)) << asked;
        const std::vector<std::string> rows = marked_lines(tuned, "  best");
        ASSERT_EQ(rows.size(), 1u) << tuned;
        // Fewer settings are tried, so fewer are equal.
        const auto but_equal = [](const std::string& row) {
            return row.substr(0, row.find(" and "));
        };
        const std::vector<std::string> marked = marked_lines(inspected, "  best");
        ASSERT_EQ(marked.size(), 1u) << inspected;
        EXPECT_EQ(but_equal(marked[0]), but_equal(rows[0])) << asked;
        EXPECT_EQ(tuned.find("Fewest operations"), std::string::npos);
    }
}

TEST(TuneCommand, SaysThatOneRunHasNoInterval) {
    const std::string text = run_scb("tune cone --frames 80 --repeat 1").out;
    EXPECT_NE(text.find("ms, one run"), std::string::npos) << text;
    EXPECT_NE(text.find("one run, which cannot tell"), std::string::npos) << text;
    for (const char* interval : {"no measurable difference", "[least, most]", "interval"})
        EXPECT_EQ(text.find(interval), std::string::npos) << interval;
    EXPECT_EQ(marked_lines(text, "  best").size(), 1u) << text;
}

TEST(TuneCommand, WhatIsLeftOutIsNotBetter) {
    for (const char* scene :
         {"cone --frames 60:120:20", "soup --frames 60", "long-triangles --frames 120"}) {
        const std::string asked = std::string(scene) + " --no-time";
        const json some = tune(asked), every = tune(asked + " --every");
        EXPECT_GT(every["settings"].size(), some["settings"].size()) << scene;
        EXPECT_LE(least_of(some, "n_v").get<double>(), 1.1 * least_of(every, "n_v").get<double>())
            << scene;
        EXPECT_LE(least_of(some, "cost").get<double>(), 1.1 * least_of(every, "cost").get<double>())
            << scene;
    }
}

TEST(TuneCommand, NamesTheCommandThatUsesTheBest) {
    const std::string text = run_scb("tune cone --frames 80 --no-time").out;
    const std::string words = "Unpacked: scb ";
    const std::size_t at = text.find(words);
    ASSERT_NE(at, std::string::npos) << text;
    const std::string command = text.substr(at + words.size());
    const json found = tune("cone --frames 80 --no-time");
    const json mean =
        json::parse(run_scb(command.substr(0, command.find('\n')) + " --json").out)["mean"];
    EXPECT_EQ(mean["n_v"], found["settings"][found["best"]["cost"].get<std::size_t>()]["n_v"]);
    // The packed layout has a command of its own, and costs less.
    const std::string packed = found["layout_command"];
    EXPECT_NE(text.find("To use it: " + packed + "\n"), std::string::npos) << text;
    const json& layout = found["layouts"][found["best"]["layout"].get<std::size_t>()];
    EXPECT_EQ(json::parse(run_scb(packed.substr(4) + " --json").out)["mean"]["n_v"], layout["n_v"]);
    EXPECT_LT(layout["cost"], found["settings"][found["best"]["cost"].get<std::size_t>()]["cost"]);
}

TEST(TuneCommand, TheBaseIsWhatWasAsked) {
    const json found = tune(
        "cone --frames 80 --no-time --test line8 --threshold 0.33 --descent area --growth radius "
        "--split cost --margin 0.01");
    const json base = found["settings"][0];
    EXPECT_EQ(base["test"], "line8");
    EXPECT_EQ(base["threshold"], 0.33);
    EXPECT_EQ(base["descent"], "area");
    EXPECT_EQ(base["growth"], "radius");
    EXPECT_EQ(base["split"], "cost");
    const json mean = json::parse(
        run_scb("collide cone --frames 80 --json --margin 0.01" + options_of(base)).out)["mean"];
    EXPECT_EQ(base["n_v"], mean["n_v"]);
}

TEST(TuneCommand, TakesEveryVolumeAsItsBase) {
    const TemporaryFolder folder;
    for (const char* volume : {"scb2", "ball", "ritter", "obb"}) {
        const std::string asked = " --frames 80 --margin 0.1 --volume " + std::string(volume);
        const json found = tune("cone --no-time --size 640x480 -o " + folder.path.string() + asked);
        EXPECT_EQ(found["volume"], volume);
        const json base = found["settings"][0];
        EXPECT_EQ(base["volume"], volume);
        EXPECT_FALSE(base.contains("test"));
        const json mean = json::parse(run_scb("collide cone --json" + asked).out)["mean"];
        for (const char* count : {"n_v", "n_p", "pairs"}) EXPECT_EQ(base[count], mean[count]);
        EXPECT_EQ(lines_of(file_text(folder / ("cone_tune_volume-" + std::string(volume) +
                                               "_margin-0.1_frames-80_no-time.csv"))),
                  lines_of_csv(found));
    }
    // Each run has tables of its own.
    EXPECT_EQ(files_in(folder.path.string()), 12u);
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
    for (const char* file : {"cone_tune_frames-0-to-160-by-40_no-time.csv",
                             "cone_tune_frames-0-to-160-by-40_no-time.json",
                             "cone_tune_frames-0-to-160-by-40_no-time.png"})
        EXPECT_EQ(file_text(folder.path / "a" / file), file_text(folder.path / "b" / file)) << file;
}

TEST(TuneCommand, TimesTheBestSettingsAndWritesFiles) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const json found = tune("cone --frames 60,80 --repeat 1 --size 640x480 -o " + out);
    std::size_t timed = 0;
    for (const json& setting : found["settings"]) {
        EXPECT_GT(setting["build_ms"], 0);
        if (!setting.contains("ms")) continue;
        ++timed;
        EXPECT_GT(setting["ms_least"], 0);
        EXPECT_LE(setting["ms_least"], setting["ms"]);
        EXPECT_LE(setting["ms"], setting["ms_most"]);
    }
    EXPECT_GE(timed, 5u);
    EXPECT_TRUE(found["settings"][0].contains("ms"));
    EXPECT_TRUE(found["settings"][found["best"]["time"].get<std::size_t>()].contains("ms"));
    EXPECT_EQ(json::parse(file_text(out + "/cone_tune_frames-60-80_repeat-1.json")), found);
    EXPECT_EQ(lines_of(file_text(out + "/cone_tune_frames-60-80_repeat-1.csv")),
              lines_of_csv(found));
    for (const json& layout : found["layouts"]) EXPECT_GT(layout["ms_least"], 0);
    const render::Image picture =
        render::read_png(fs::path(out) / "cone_tune_frames-60-80_repeat-1_size-640x480.png");
    EXPECT_EQ(picture.width, 640);
    EXPECT_EQ(picture.height, 480);
    const std::string table = run_scb("tune cone --frames 60 --repeat 1").out;
    for (const char* part : {"Best of ", " settings: ", "cost: ", "To use it: "})
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
        run_scb_process("tune " + scene + " --frames all --quiet -o " + (folder / "out") +
                        " & child=$!; sleep 1; kill -TERM $child; wait $child");
    EXPECT_EQ(run.status, 143) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(files_in(folder / "out"), 0u);
}

TEST(TuneCommand, ReplacesNothingThatTheSceneWasReadFrom) {
    const TemporaryFolder folder;
    const std::string scene = folder / "cone_tune_frames-1_no-time.json",
                      text = run_scb("scenes cone").out;
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
