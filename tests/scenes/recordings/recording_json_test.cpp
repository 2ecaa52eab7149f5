#include "scenes/recordings/recording_json.h"

#include <gtest/gtest.h>

#include "scb/error.h"
#include "tests/scenes/recordings/sample_records.h"

namespace scb::scenes {
namespace {

std::string refusal_of_text(const std::string& text) {
    try {
        recording_of_json(text, "x.jsonl");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(RecordingJson, HoldsTheSame) {
    const std::string bytes = recording_of(sample_records()),
                      text = recording_as_json(bytes, "x.scbrec");
    EXPECT_EQ(recording_of_json(text, "x.jsonl"), bytes);
    EXPECT_EQ(recording_as_json(recording_of_json(text, "x.jsonl"), "x.scbrec"), text);
}

TEST(RecordingJson, SaysWhatAReaderExpects) {
    EXPECT_EQ(
        recording_as_json(
            recording_of(
                {RecordedNode{1, 2, 0, 7, "n", {}, {3}, {RecordedKind::ball, {0, 0.5, 0, 1}}},
                 RecordedQuery{0, 1}, RecordedEvent{0, 5, 6}, RecordedEvent{129, 8, 9},
                 RecordedEnd{}}),
            "x.scbrec"),
        R"({"node":2,"in_tree":1,"parent":0,"id":7,"name":"n","children":[],"items":[3],"volume":["ball",0.0,0.5,0.0,1.0]}
{"query":[0,1]}
{"tests":[[0,5,6],["meet",8,9]]}
{"end":true}
)");
}

TEST(RecordingJson, LeavesOutWhatIsNothing) {
    EXPECT_EQ(
        records_of(recording_of_json("{\"node\": 2, \"in_tree\": 1}\n\n{\"tree\": 1}", "x.jsonl")),
        (std::vector<Record>{RecordedNode{1, 2, record_none, 0, "", {}, {}, {}},
                             RecordedTree{1, record_none, "", {}}}));
}

TEST(RecordingJson, NamesTheLineThatItRefuses) {
    EXPECT_EQ(refusal_of_text("{\"frame\": 0}\n{\"frame\": -1}\n").find("x.jsonl: line 2: "), 0u);
    for (const char* text :
         {"{",
          "[]",
          "{}",
          "{\"frame\": 0, \"name\": \"\"}",
          "{\"frame\": 4294967296}",
          "{\"tests\": [[0, 1]]}",
          "{\"tests\": [[\"hit\", 1, 2]]}",
          "{\"tests\": [[192, 1, 2]]}",
          "{\"mesh\": 0, \"coordinates\": [1, 2]}",
          "{\"mesh\": 0, \"coordinate_bytes\": 2}",
          "{\"mesh\": 0, \"coordinate_bytes\": 4, \"coordinates\": [0, 0, 1e39]}",
          "{\"mesh\": 0, \"indices\": [1, 2]}",
          "{\"tree\": 0, \"directions\": [1, 0, 0, 1]}",
          "{\"refit\": 0, \"in_tree\": 0, \"volume\": [\"ball\", \"nan:3ff0000000000000\"]}",
          "{\"refit\": 0, \"in_tree\": 0, \"volume\": [\"cube\", 1]}",
          "{\"refit\": 0, \"in_tree\": 0, \"volume\": [\"ball\", \"one\"]}",
          "{\"pose\": 0, \"rows\": [1]}",
          "{\"query\": [0]}",
          "{\"unknown\": 200, \"hex\": \"\"}",
          "{\"unknown\": 203, \"hex\": \"\"}",
          "{\"unknown\": 250, \"hex\": \"0\"}",
          "{\"setting\": {\"hex\": \"zz\"}, \"value\": \"\"}"}) {
        const std::string sentence = refusal_of_text(text);
        EXPECT_TRUE(sentence.starts_with("x.jsonl: line 1")) << text << ": " << sentence;
    }
}

}  // namespace
}  // namespace scb::scenes
