#include "golden/suite/case_counts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scb/error.h"

namespace scb::golden {
namespace {

using nlohmann::json;

const json queries = json::parse(R"({
  "version": "0.1.0", "scene": "s", "mean": {"n_v": 1.5},
  "frames": [
    {"frame": 0, "pose": [1, 0, 0], "pairs": 2, "n_v": 7, "complete": true,
     "pairs_hash": "cbf29ce484222325", "stages": {"ball-slab": 3}},
    {"frame": 10, "pairs": 0, "n_v": 1, "complete": false, "pairs_hash": "00000000000007ff", "stages": {"ball-slab": 1}}
  ]
})");

TEST(CaseCounts, AreIntegersByFrame) {
    EXPECT_EQ(case_counts(GoldenRun::collide, queries), json::parse(R"({
      "frames": {
        "0": {"complete": 1, "n_v": 7, "pairs": 2, "pairs_hash": 7175771991868484, "stages": {"ball-slab": 3}},
        "10": {"complete": 0, "n_v": 1, "pairs": 0, "pairs_hash": 0, "stages": {"ball-slab": 1}}
      }
    })"));
}

TEST(CaseCounts, TellPairsApartThatAreAsMany) {
    json others = queries;
    others["frames"][0]["pairs_hash"] = "cbf29ce484222b25";
    EXPECT_NE(case_counts(GoldenRun::collide, others), case_counts(GoldenRun::collide, queries));
    for (const json& none : {json(5), json("abc"), json("cbf29ce48422232x"), json()}) {
        others["frames"][0]["pairs_hash"] = none;
        EXPECT_THROW(case_counts(GoldenRun::collide, others), InputError) << none;
    }
}

TEST(CaseCounts, OfDistancesHaveTheDistanceAndItsBound) {
    const json distances = json::parse(R"({"query": "distance", "relative_error": 0.0, "frames": [
      {"frame": 0, "distance": 0.5, "rounding": 1e-15, "triangles": [3, 4],
       "points": [[0.5, 0.0, 0.0], [1.0, 0.0, 0.0]], "signed_distance": 0.5, "inside": [],
       "n_v": 7, "stages": {"near": 2}},
      {"frame": 1, "distance": 0.0, "rounding": 2e-15, "triangles": [5, 6], "inside": [], "n_v": 2},
      {"frame": 2, "distance": null, "triangles": null, "inside": null, "n_v": 1}]})");
    EXPECT_EQ(case_counts(GoldenRun::distance, distances), json::parse(R"({"frames": {
      "0": {"distance": {"value": 0.5, "bound": 1e-15}, "triangles": {"a": 3, "b": 4},
            "inside": 0, "n_v": 7, "stages": {"near": 2}},
      "1": {"distance": {"value": 0.0, "bound": 2e-15}, "inside": 0, "n_v": 2},
      "2": {"n_v": 1}}})"));
}

TEST(CaseCounts, ListsAreByTheNamesOfTheirElements) {
    const json levels = json::parse(R"({"files": [{"file": "a.png", "frame": 3, "bodies": [
      {"body": "A", "first_id": 1, "volumes": 4}, {"body": "B", "first_id": 9, "volumes": 5}]}]})");
    EXPECT_EQ(case_counts(GoldenRun::levels, levels), json::parse(R"({"frames": {"3": {"bodies": {
      "A": {"volumes": 4}, "B": {"volumes": 5}}}}})"));
    json twice = levels;
    twice["files"][0]["bodies"][1]["body"] = "A";
    EXPECT_THROW(case_counts(GoldenRun::levels, twice), InputError);
    json nameless = levels;
    nameless["files"][0]["bodies"][1].erase("body");
    EXPECT_THROW(case_counts(GoldenRun::levels, nameless), InputError);
}

TEST(CaseCounts, OfSeveralQueriesOfAFrameAreByTheirBodies) {
    const json frames = json::parse(R"({"frames": [{"frame": 3, "queries": [
      {"bodies": ["A", "B"], "depth": 4, "pairs": 1}, {"bodies": ["A", "C"], "depth": 4, "pairs": 0}]}]})");
    EXPECT_EQ(case_counts(GoldenRun::collide, frames), json::parse(R"({"frames": {"3": {"queries": {
      "[\"A\",\"B\"]": {"depth": 4, "pairs": 1}, "[\"A\",\"C\"]": {"depth": 4, "pairs": 0}}}}})"));
}

TEST(CaseCounts, OfARecordingThatLeavesOutQueriesAreRefused) {
    json some = queries;
    some["left_out"] = 1;
    EXPECT_THROW(case_counts(GoldenRun::external, some), InputError);
}

TEST(CaseCounts, OfOneFrameTwiceAreRefused) {
    json twice = queries;
    twice["frames"][1]["frame"] = 0;
    try {
        case_counts(GoldenRun::collide, twice);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("frames has 0 twice"), std::string::npos)
            << error.what();
    }
}

TEST(CaseCounts, MustBeThere) {
    for (const char* text : {"{}", "[]", "5", R"({"frames": []})", R"({"frames": {}})",
                             R"({"frames": [1, 2]})", R"({"frames": "none"})"})
        EXPECT_THROW(case_counts(GoldenRun::collide, json::parse(text)), InputError) << text;
    EXPECT_THROW(case_counts(GoldenRun::pairs, queries), InputError);
}

TEST(CaseCounts, OfAnInspectionAreItsTables) {
    const json inspection = json::parse(R"({
      "frames": [{"frame": 4, "pairs": 1}], "sum": {"pairs": 1}, "depths": [{"depth": 0, "n_v": 1}],
      "other_tests": [{"test": "corrected", "threshold": 0.7, "caught": 2}, {"test": "extents", "caught": 3}],
      "worst": [{"frame": 4, "nodes": [1, 2]}, {"frame": 4, "nodes": [3, 4]}]
    })");
    EXPECT_EQ(case_counts(GoldenRun::inspect, inspection), json::parse(R"({
      "frames": {"4": {"pairs": 1}}, "sum": {"pairs": 1}, "depths": {"0": {"depth": 0, "n_v": 1}},
      "other_tests": {"corrected 0.7": {"caught": 2}, "extents": {"caught": 3}}
    })"));
    json balls = inspection;
    balls["other_tests"] = json::array();
    EXPECT_EQ(case_counts(GoldenRun::inspect, balls)["other_tests"], json::object());
}

TEST(CaseCounts, KnowTheirOnlyFrame) {
    json one = queries;
    EXPECT_EQ(only_frame(case_counts(GoldenRun::collide, one)), "");
    one["frames"].erase(0);
    EXPECT_EQ(only_frame(case_counts(GoldenRun::collide, one)), "10");
    EXPECT_EQ(only_frame(json::object()), "");
}

}  // namespace
}  // namespace scb::golden
