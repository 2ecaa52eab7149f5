#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/app/program.h"

namespace scb {
namespace {

using nlohmann::json;

json inspect(const std::string& arguments, int status = 0) {
    const ProgramRun run = run_scb("inspect --json " + arguments);
    EXPECT_EQ(run.status, status) << arguments << run.err;
    return json::parse(run.out);
}

std::uint64_t count(const json& entry, const std::string& reason) {
    return entry["inner"][reason].get<std::uint64_t>() +
           entry["leaves"][reason].get<std::uint64_t>();
}

TEST(InspectCommand, AddsUpToWhatCollideCounts) {
    for (const char* options : {"", "--volume obb", "--volume ball",
                                "--test extents --descent area", "--max-pairs 5", "--level 6"}) {
        const std::string arguments = "spheres-l1 --frames 0,60,250 " + std::string(options);
        const json found = inspect(arguments),
                   live = json::parse(run_scb("collide --json " + arguments).out);
        ASSERT_EQ(found["frames"].size(), 3u);
        std::uint64_t previous = UINT64_MAX, wasted = 0;
        for (const json& frame : found["frames"]) {
            json counts;
            for (const json& other : live["frames"])
                if (other["frame"] == frame["frame"]) counts = other;
            for (const char* key : {"pairs", "n_v", "n_p"}) EXPECT_EQ(frame[key], counts[key]);
            EXPECT_EQ(frame["passed"], counts["stages"]["overlapping"]) << options;
            EXPECT_EQ(frame["passed"],
                      count(frame, "test") + count(frame, "fit") + count(frame, "true"));
            EXPECT_EQ(frame["work"]["n_v"], frame["n_v"]);
            const std::uint64_t here = frame["wasted"]["n_v"];
            EXPECT_EQ(here, frame["wasted_by"]["test"]["n_v"].get<std::uint64_t>() +
                                frame["wasted_by"]["fit"]["n_v"].get<std::uint64_t>());
            EXPECT_LE(here, previous) << "the worst frame comes first";
            previous = here;
            wasted += here;
        }
        EXPECT_EQ(found["sum"]["wasted"]["n_v"], wasted);
        std::uint64_t tests = 0;
        for (const json& depth : found["depths"]) tests += depth["n_v"].get<std::uint64_t>();
        EXPECT_EQ(found["sum"]["n_v"], tests);
    }
}

TEST(InspectCommand, SaysTheSameOfATrace) {
    const TemporaryFolder folder;
    const std::string trace = folder / "t.scbtrace";
    for (const char* arguments :
         {"spheres-l1 --frames 60,100 --test corrected --threshold 0.8",
          "spheres-l1 --frames 60 --max-pairs 3", "knots-l1 --frames 7 --volume obb --level 4"}) {
        ASSERT_EQ(run_scb("trace " + std::string(arguments) + " -o " + trace).status, 0);
        EXPECT_EQ(run_scb("inspect " + trace + " --frames all").out,
                  run_scb("inspect " + std::string(arguments)).out);
    }
}

TEST(InspectCommand, TheWorstPairsAreFalse) {
    const json found = inspect("spheres-l1 --frame 60 --top 3");
    ASSERT_EQ(found["worst"].size(), 6u);
    const json collisions = json::parse(run_scb("collide --json spheres-l1 --frames 60").out);
    for (const json& pair : found["worst"]) {
        EXPECT_EQ(pair["frame"], 60);
        EXPECT_GT(pair["wasted"]["n_v"].get<int>() + pair["wasted"]["n_p"].get<int>(), 0);
        EXPECT_EQ(pair["exact"] == "disjoint", pair["reason"] == "test");
        EXPECT_EQ(pair["gap"].get<double>() > 0, pair["reason"] == "test");
    }
    for (const std::size_t i : {0u, 1u, 3u, 4u})
        EXPECT_GE(found["worst"][i]["wasted"]["n_v"].get<int>() +
                      found["worst"][i]["wasted"]["n_p"].get<int>(),
                  found["worst"][i + 1]["wasted"]["n_v"].get<int>() +
                      found["worst"][i + 1]["wasted"]["n_p"].get<int>());
    // The wasted work of the worst pair is no more than the frame's.
    EXPECT_LT(found["worst"][0]["wasted"]["n_v"], collisions["frames"][0]["n_v"]);
}

TEST(InspectCommand, PrintedRejectsWronglyAndNoOtherTestDoes) {
    const ProgramRun run = run_scb("inspect spheres-l1 --frame 60 --test printed");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("pairs of volumes that overlap"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("REJECTED WRONGLY"), std::string::npos);
    for (const char* test : {"line8", "corrected", "symmetric", "extents"})
        EXPECT_EQ(
            inspect("spheres-l1 --frame 60 --test " + std::string(test))["sum"]["wrongly_rejected"],
            0);
    const json wrong = inspect("spheres-l1 --frame 60 --test printed", 1);
    EXPECT_GT(wrong["sum"]["wrongly_rejected"], 0);
    EXPECT_EQ(wrong["wrongly_rejected"].size(), 10u);
    // What printed lost counts as contact nevertheless.
    EXPECT_EQ(inspect("spheres-l1 --frame 60")["worst"][0]["nodes"], wrong["worst"][0]["nodes"]);
}

TEST(InspectCommand, OtherTestsAreWholeQueries) {
    const json found = inspect("spheres-l1 --frames 60,100");
    ASSERT_EQ(found["other_tests"].size(), 4u);
    for (const json& other : found["other_tests"]) {
        std::string arguments =
            "collide --json spheres-l1 --frames 60,100 --test " + other["test"].get<std::string>();
        if (other.contains("threshold")) arguments += " --threshold " + other["threshold"].dump();
        std::uint64_t n_v = 0, n_p = 0, pairs = 0;
        const json live = json::parse(run_scb(arguments).out);
        for (const json& frame : live["frames"]) {
            n_v += frame["n_v"].get<std::uint64_t>();
            n_p += frame["n_p"].get<std::uint64_t>();
            pairs += frame["pairs"].get<std::uint64_t>();
        }
        EXPECT_EQ(other["n_v"], n_v) << arguments;
        EXPECT_EQ(other["n_p"], n_p) << arguments;
        EXPECT_EQ(other["pairs"], pairs) << arguments;
    }
    EXPECT_EQ(inspect("spheres-l1 --frame 60 --volume obb")["other_tests"].size(), 0u);
}

TEST(InspectCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    const std::string trace = folder / "t.scbtrace";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 60 -o " + trace).status, 0);
    for (const auto& [arguments, said] :
         {std::pair<std::string, std::string>{"spheres-l1 --top 0", "1 to 10000"},
          {"spheres-l1 --frame 500", "0 to 499"},
          {"spheres-l1 --frame -1", "0 to 499"},
          {"spheres-l1 --frame 1 --frames 2", "--frame"},
          {"spheres-l1 --volume scb,ball", "one"},
          {trace + " --test extents", "is a trace"},
          {trace + " --frame 61", "60"}}) {
        const ProgramRun run = run_scb("inspect " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_NE(run.err.find(said), std::string::npos) << arguments << ": " << run.err;
    }
}

}  // namespace
}  // namespace scb
