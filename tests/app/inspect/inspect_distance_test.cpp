#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/inspect/inspect_run.h"
#include "tests/recordings/distance_engine.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

using nlohmann::json;

std::uint64_t sum_of(const json& by_reason) {
    std::uint64_t sum = 0;
    for (const json& one : by_reason)
        sum += one.is_number() ? one.get<std::uint64_t>() : one["n_v"].get<std::uint64_t>();
    return sum;
}

/// Sums of the frames that a command of an advice counts.
std::array<std::uint64_t, 2> counted_by(const std::string& command) {
    std::array<std::uint64_t, 2> sums{};
    const json found = json::parse(run_scb(command.substr(4) + " --json").out);
    for (const json& frame : found["frames"]) {
        sums[0] += frame["n_v"].get<std::uint64_t>();
        sums[1] += frame["n_p"].get<std::uint64_t>();
    }
    return sums;
}

TEST(InspectDistance, AddsUpToWhatDistanceCounts) {
    for (const char* options :
         {"", "--volume ball --order depth-first", "--volume obb --relative-error 0.1",
          "--within 0.1", "--volume rss --split paper --limit 0.2"}) {
        const std::string arguments = "spheres-l1 --frames 0,10 " + std::string(options);
        SCOPED_TRACE(arguments);
        const json found = inspect("--no-advice --kind distance " + arguments),
                   live = json::parse(run_scb("distance --json " + arguments).out);
        ASSERT_EQ(found["frames"].size(), 2u);
        const bool is_within = found["query"] == "within";
        std::vector<std::string> reasons = {"test", "fit", "true"};
        if (!is_within) reasons.emplace_back("early");
        reasons.emplace_back("not_judged");
        for (const json& frame : found["frames"]) {
            json counts;
            for (const json& other : live["frames"])
                if (other["frame"] == frame["frame"]) counts = other;
            for (const char* key : {"n_v", "n_p", is_within ? "pairs" : "distance"})
                EXPECT_EQ(frame[key], counts[key]) << key;
            EXPECT_EQ(frame["passed"], counts["stages"]["near"]);
            std::uint64_t passed = 0;
            for (const std::string& reason : reasons) passed += count(frame, reason);
            EXPECT_EQ(frame["passed"], passed);
            EXPECT_EQ(frame["inner"].size(), reasons.size());
            EXPECT_EQ(frame["wasted"]["n_v"], sum_of(frame["wasted_by"]));
            EXPECT_EQ(frame["wasted_by"].size(), reasons.size() - 1);
            EXPECT_EQ(frame["wrongly_rejected"], 0);
            EXPECT_GT(frame["wasted"]["n_v"], 0);
            // What does not apply to distances is not there.
            for (const char* key : {"touching", is_within ? "distance" : "pairs"})
                EXPECT_FALSE(frame.contains(key)) << key;
            EXPECT_FALSE(frame["work"].contains("operations"));
        }
        std::uint64_t tests = 0, wasted = 0;
        for (const json& depth : found["depths"]) {
            tests += depth["n_v"].get<std::uint64_t>();
            wasted += sum_of(depth["wasted_by"]);
        }
        EXPECT_EQ(found["sum"]["n_v"], tests);
        EXPECT_EQ(found["sum"]["wasted"]["n_v"], wasted);
        EXPECT_FALSE(found.contains("other_tests"));
        if (is_within) continue;
        const bool is_proven = arguments.find("error") == std::string::npos;
        EXPECT_EQ(found["distances"], 2);
        if (is_proven) {
            EXPECT_EQ(found["certified"], 2);
        }
    }
}

TEST(InspectDistance, SaysWhatWasWastedAndWhatWouldHelp) {
    const ProgramRun run =
        run_scb("inspect spheres-l1 --frames 0,10 --kind distance --volume ball --full");
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* words :
         {"A and B, ball", "2 of 2 distances certified.", "since bounds are too weak",
          "before the distance was known", "led to the answer", "passed too early",
          "What would have helped", "To use it:  scb distance spheres-l1 --frames 0,10"})
        EXPECT_NE(run.out.find(words), std::string::npos) << words << run.out;
    for (const char* words : {"operations", "overlap test", "true contact", "intersect"})
        EXPECT_EQ(run.out.find(words), std::string::npos) << words;
}

TEST(InspectDistance, ItsCommandCountsWhatTheReportSays) {
    for (const char* options : {"", "--within 0.1", "--growth radius", "--descent volume"}) {
        SCOPED_TRACE(options);
        const json settings = inspect("spheres-l1 --frames 0:20:10 --kind distance --volume ball " +
                                      std::string(options))["settings"];
        const json& best = settings["settings"][settings["best"].get<std::size_t>()];
        const std::string command = settings["command"];
        const auto [n_v, n_p] = counted_by(command);
        EXPECT_EQ(best["n_v"], n_v) << command;
        EXPECT_EQ(best["n_p"], n_p) << command;
        EXPECT_LT(best["cost"], settings["settings"][0]["cost"]);
        const std::string timing = settings["timing"];
        EXPECT_EQ(run_scb(timing.substr(4) + " --repeat 1").status, 0) << timing;
    }
}

/// The recording of a healthy engine, as text.
std::string recording_text(const TemporaryFolder& folder) {
    record_distance_engine(DistanceBug::none, folder / "q.scbrec");
    EXPECT_EQ(run_scb("convert " + folder / "q.scbrec" + " -o " + folder / "q.jsonl").status, 0);
    std::stringstream text;
    text << std::ifstream(folder / "q.jsonl").rdbuf();
    return text.str();
}

/// The same with a change from one text to another. Returns the file.
std::string changed_recording(const TemporaryFolder& folder, std::string_view from,
                              const std::string& to, int occurrence) {
    std::string changed = recording_text(folder);
    std::size_t at = changed.find(from);
    while (--occurrence > 0) at = changed.find(from, at + 1);
    changed.replace(at, from.size(), to);
    const std::string file = folder / "changed.jsonl";
    std::ofstream(file) << changed;
    return file;
}

TEST(InspectDistance, ComparesARecordingWithThisProjectsHierarchies) {
    const TemporaryFolder folder;
    const std::string file = folder / "q.scbrec";
    record_distance_engine(DistanceBug::none, file);
    for (const char* query : {"nearest", "near"}) {
        const json found = inspect(file + " --frames 1 --query " + std::string(query)),
                   &settings = found["settings"];
        EXPECT_EQ(settings["recorded"]["n_v"], found["waste"]["sum"]["n_v"]);
        EXPECT_EQ(settings["recorded"]["n_p"], found["waste"]["sum"]["work"]["n_p"]);
        const json& best = settings["settings"][settings["best"].get<std::size_t>()];
        const std::string command = settings["command"];
        const json counted = json::parse(run_scb(command.substr(4) + " --json").out);
        ASSERT_EQ(counted["frames"].size(), 1u);
        EXPECT_EQ(best["n_v"], counted["frames"][0]["n_v"]) << command;
        EXPECT_LT(best["n_v"], settings["recorded"]["n_v"]);
        EXPECT_EQ(command.find("--within 1.5 ") != std::string::npos, query == std::string("near"));
    }
}

TEST(InspectDistance, CountsTheFramesThatHaveRecordedQueries) {
    const TemporaryFolder folder;
    // The queries of the first frame again in frame 3, with the same meshes. Frame 2 has none.
    const std::string text = recording_text(folder);
    const std::size_t queries = text.find("{\"query\""), second = text.find("{\"frame\":1"),
                      end = text.rfind("\n{") + 1;
    ASSERT_LT(queries, second);
    const std::string file = folder / "again.jsonl";
    std::ofstream(file) << text.substr(0, second) << "{\"frame\":2}\n{\"frame\":3}\n"
                        << text.substr(queries, second - queries) << text.substr(end);
    const json found = inspect("--query nearest " + file), &settings = found["settings"];
    EXPECT_EQ(settings["frames"], json::array({0, 3}));
    EXPECT_EQ(settings["settings"][0]["split"], "cost") << "the default of distances";
    const json& best = settings["settings"][settings["best"].get<std::size_t>()];
    const auto [n_v, n_p] = counted_by(settings["command"]);
    EXPECT_EQ(best["n_v"], n_v) << settings["command"];
    EXPECT_EQ(best["n_p"], n_p);
    const std::string timing = settings["timing"];
    EXPECT_EQ(run_scb(timing.substr(4) + " --repeat 1").status, 0) << timing;
}

TEST(InspectDistance, ComparesNoRecordingWhoseQueriesDiffer) {
    const struct {
        std::string_view from;
        const char *to, *reason;
    } cases[] = {
        {"\"limit\":\"inf\"", "\"limit\":5", "several limits or relative errors"},
        {"\"relative_error\":0.0", "\"relative_error\":0.5", "several limits or relative errors"},
        {"{\"complete\":true", "{\"complete\":false",
         "the query of frame 1 ended early on purpose"}};
    for (const auto& [from, to, reason] : cases) {
        const TemporaryFolder folder;
        // The third query is the query "nearest" of the second frame.
        const int occurrence = from.find("limit") == std::string_view::npos ? 3 : 2;
        const std::string file = changed_recording(folder, from, to, occurrence);
        const ProgramRun run = run_scb("inspect --query nearest " + file);
        EXPECT_EQ(run.status, 0) << run.err << run.out;
        EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
        EXPECT_EQ(run.out.find("This project's best"), std::string::npos) << run.out;
        const ProgramRun first = run_scb("inspect --query nearest --frames 0 " + file);
        EXPECT_NE(first.out.find("This project's best"), std::string::npos) << first.err;
    }
}

TEST(InspectDistance, BallsAreLooseAndBoundsOfBallsAreExact) {
    const auto wasted = [](const std::string& volume) {
        return inspect("spheres-l1 --frames 0 --kind distance --no-advice --volume " +
                       volume)["sum"]["wasted_by"];
    };
    const json ball = wasted("ball"), scb2 = wasted("scb2");
    EXPECT_EQ(ball["test"]["n_v"], 0) << "the bound of two balls is their distance";
    EXPECT_GT(ball["fit"]["n_v"], 4 * scb2["fit"]["n_v"].get<std::uint64_t>());
}

TEST(InspectDistance, WritesAPageWithoutWhatDoesNotApply) {
    const TemporaryFolder folder;
    const ProgramRun run =
        run_scb("inspect spheres-l1 --frames 0 --kind distance -o " + folder / "");
    ASSERT_EQ(run.status, 0) << run.err;
    std::string page, frames, pairs;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
        const std::string name = entry.path().filename().string();
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        if (name.ends_with(".html") && !name.ends_with("_view.html")) page = text.str();
        if (name.ends_with("_frames.csv")) frames = text.str();
        if (name.ends_with("_pairs.csv")) pairs = text.str();
    }
    for (const char* words : {"1 of 1 distance certified.", "bound too weak", "passed too early",
                              "beyond the answer by", "_view.html#frame=0&amp;nodes="})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    for (const char* words : {"operations", "test too weak", "true contact", "scb explain"})
        EXPECT_EQ(page.find(words), std::string::npos) << words;
    EXPECT_TRUE(frames.starts_with("frame,distance,certified,n_v,n_p,passed,true,fit,test,early,"));
    EXPECT_TRUE(pairs.starts_with("frame,node_a,node_b,depth_a,depth_b,reason,beyond,leaves,"));
}

TEST(InspectDistance, RefusesOptionsOfOverlap) {
    for (const char* option : {"--test printed", "--max-pairs 5", "--layout quantized8"}) {
        const ProgramRun run = run_scb("inspect spheres-l1 --kind distance " + std::string(option));
        EXPECT_NE(run.status, 0) << option;
        EXPECT_NE(run.err.find("it is for queries of overlap"), std::string::npos) << run.err;
    }
    EXPECT_NE(run_scb("inspect spheres-l1 --order nearest").status, 0);
}

}  // namespace
}  // namespace scb::app
