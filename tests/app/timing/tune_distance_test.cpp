#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

json tune_distance(const std::string& arguments) {
    const ProgramRun run = run_scb("tune --json " + arguments);
    EXPECT_EQ(run.status, 0) << arguments << run.err;
    return json::parse(run.out);
}

/// What `scb distance` is to be asked for the same.
std::string distance_options_of(const json& setting) {
    std::string options;
    for (const char* option : {"volume", "split", "order", "layout"})
        if (setting.contains(option))
            options += " --" + std::string(option) + " " + setting[option].get<std::string>();
    return options + (setting.contains("leaf") ? " --leaf " + setting["leaf"].dump() : "");
}

/// The index of the first setting, with a layout or not, that was surely quicker than the base.
std::size_t first_quicker(const json& settings, bool packed_too) {
    for (std::size_t i = 1; i < settings.size(); ++i)
        if ((packed_too || settings[i]["layout"] == "reference") &&
            settings[i]["ms_most"] < settings[0]["ms_least"])
            return i;
    return 0;
}

/// The mean of a count over the frames of `scb distance` with these arguments.
double mean_of_distance(const std::string& arguments, const char* count) {
    const ProgramRun run = run_scb("distance --json " + arguments);
    EXPECT_EQ(run.status, 0) << arguments << run.err;
    const json frames = json::parse(run.out)["frames"];
    double sum = 0;
    for (const json& frame : frames) sum += frame[count].get<double>();
    return sum / static_cast<double>(frames.size());
}

void expect_counts_of_distance(const json& found, const std::string& query) {
    const json& settings = found["settings"];
    ASSERT_GE(settings.size(), 2u);
    std::set<std::string> seen;
    for (const json& setting : settings) {
        const std::string options = distance_options_of(setting);
        EXPECT_TRUE(seen.insert(options).second) << options;
        for (const char* count : {"n_v", "n_p"})
            EXPECT_EQ(setting[count], mean_of_distance(query + options, count)) << options << count;
        EXPECT_LE(setting["ms_least"], setting["ms"]);
        EXPECT_LE(setting["ms"], setting["ms_most"]);
    }
    EXPECT_TRUE(std::is_sorted(settings.begin() + 1, settings.end(),
                               [](const json& x, const json& y) { return x["ms"] < y["ms"]; }));
    EXPECT_TRUE(std::any_of(settings.begin(), settings.end(),
                            [](const json& setting) { return setting["layout"] != "reference"; }));
}

TEST(TuneDistance, TimesTheQueriesOfDistance) {
    const json found = tune_distance("stack --kind distance --frames 0,25 --repeat 2");
    EXPECT_EQ(found["query"], "distance");
    EXPECT_EQ(found["timed_frames"], json({0, 25}));
    EXPECT_EQ(found["tried"], 216);
    const json& base = found["settings"][0];
    EXPECT_EQ(distance_options_of(base),
              " --volume scb2 --split cost --order hybrid --layout reference");
    expect_counts_of_distance(found, "stack --frames 0,25");
}

TEST(TuneDistance, TimesQueriesWithinATolerance) {
    const json found = tune_distance("cone --within 0.01 --frames 60,65 --repeat 2");
    EXPECT_EQ(found["query"], "within");
    EXPECT_EQ(found["asked"]["tolerance"], 0.01);
    EXPECT_EQ(found["tried"], 72);
    expect_counts_of_distance(found, "cone --within 0.01 --frames 60,65");
}

// Which setting is best depends on the machine; that it is surely quicker than the base does not.
TEST(TuneDistance, TheBestIsQuickerThanTheBaseOrTheBase) {
    for (const char* options : {"", " --volume obb --split paper --order depth-first"}) {
        const json found =
            tune_distance("stack --kind distance --frames 0,25" + std::string(options));
        const json& best = found["best"];
        EXPECT_EQ(best["recommended"], first_quicker(found["settings"], true));
        EXPECT_EQ(best["unpacked"], first_quicker(found["settings"], false));
        for (const auto& [name, command] :
             {std::pair("recommended", "command"), std::pair("unpacked", "unpacked_command")}) {
            const std::string line = found[command];
            EXPECT_TRUE(line.starts_with("scb distance stack --frames 0,25 --volume")) << line;
            EXPECT_EQ(mean_of_distance(line.substr(std::string("scb distance").size()), "n_v"),
                      found["settings"][best[name].get<std::size_t>()]["n_v"])
                << line;
        }
    }
}

TEST(TuneDistance, PrintsTheCommandAndTheLineOfCode) {
    const ProgramRun run = run_scb(
        "tune cone --kind distance --frames 60 --repeat 2 --limit 0.5 --relative-error 0.25");
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* text :
         {"the smallest distance, relative error up to 0.25, limit 0.5", "Best of 216 settings: ",
          "To use it: scb distance cone --frames 60 --relative-error 0.25 --limit 0.5 --volume ",
          ".relative_error = 0.25, .limit = 0.5})"})
        EXPECT_NE(run.out.find(text), std::string::npos) << text << "\n" << run.out;
    const ProgramRun within = run_scb("tune cone --within 0.05 --frames 60 --repeat 1");
    EXPECT_NE(within.out.find("(a, b, b_to_a, 0.05)"), std::string::npos) << within.out;
    EXPECT_NE(within.out.find("; one run"), std::string::npos) << within.out;
}

TEST(TuneDistance, SaysWhyThereAreNoLayouts) {
    const TemporaryFolder folder;
    const std::string far =
        folder.write("far.off", "OFF\n3 1 0\n1e9 0 0\n1e9 1 0\n1e9 0 1\n3 0 1 2\n");
    const ProgramRun run = run_scb("tune " + far + " " + far + " --kind distance --repeat 1");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("No packed layout was tried: "), std::string::npos) << run.out;
}

TEST(TuneDistance, RefusesOptionsOfOverlap) {
    for (const char* option : {"--no-time", "--every", "--test extents", "-o out"}) {
        const ProgramRun run = run_scb("tune cone --kind distance " + std::string(option));
        EXPECT_EQ(run.status, 2) << option;
        EXPECT_NE(run.err.find("it is for queries of overlap"), std::string::npos) << run.err;
    }
    const ProgramRun run = run_scb("tune cone --order nearest");
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("add --kind distance"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace scb::app
