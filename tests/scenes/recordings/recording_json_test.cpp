#include "scenes/recordings/recording_json.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "scenes/recordings/byte_stream.h"
#include "scenes/recordings/recording_input.h"
#include "tests/open_file_limit.h"
#include "tests/scenes/recordings/recording_block.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/temporary_folder.h"

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

/// The records of a file as they are written, one behind the other, without blocks.
std::vector<std::uint8_t> bytes_of_records(const std::string& file) {
    ByteWriter out;
    for (const Record& record : records_of(file)) {
        const auto* event = std::get_if<RecordedEvent>(&record);
        out.byte(static_cast<std::uint8_t>(record.index()));
        if (event) out.byte(event->tag), out.fixed32(event->a), out.fixed32(event->b);
        if (const auto* unknown = std::get_if<RecordedUnknown>(&record)) out.byte(unknown->tag);
        const std::vector<std::uint8_t> payload = record_payload(record);
        out.fixed32(static_cast<std::uint32_t>(payload.size()));
        out.append(payload);
    }
    return out.bytes;
}

/// A file with a mesh whose coordinates are of four bytes, with these bits.
std::string mesh_of_floats(const std::vector<std::uint32_t>& bits) {
    ByteWriter mesh;
    for (const std::uint32_t number : {1u, 0u}) mesh.fixed32(number);  // no name
    mesh.byte(4);
    mesh.fixed32(static_cast<std::uint32_t>(bits.size() / 3));
    mesh.fixed32(0);
    for (const std::uint32_t number : bits) mesh.fixed32(number);
    ByteWriter record;
    record.byte(static_cast<std::uint8_t>(RecordTag::mesh));
    record.fixed32(static_cast<std::uint32_t>(mesh.bytes.size()));
    record.append(mesh.bytes);
    return recording_with_block({record.bytes.begin(), record.bytes.end()});
}

TEST(RecordingJson, KeepsTheBitsOfFloatsThatAreNoNumbers) {
    // Quiet and signaling, with signs and fractions; infinities; the least and a usual number.
    const std::vector<std::uint32_t> bits = {0x7fc00000, 0xffc00000, 0x7fa00000,
                                             0x7f800001, 0xffbfffff, 0x7fffffff,
                                             0x7f800000, 0xff800000, 0x80000001};
    const std::string file = mesh_of_floats(bits), text = recording_as_json(file, "x.scbrec");
    EXPECT_NE(text.find("[\"nan\",\"nan:fff8000000000000\",\"nan:7ff4000000000000\","
                        "\"nan:7ff0000020000000\",\"nan:fff7ffffe0000000\","),
              std::string::npos)
        << text;
    const std::string again = recording_of_json(text, "x.jsonl");
    const std::vector<std::uint8_t> payload = record_payload(records_of(again).at(0));
    ByteReader coordinates{std::span(payload).subspan(17)};
    for (const std::uint32_t number : bits) EXPECT_EQ(coordinates.fixed32(), number);
    EXPECT_EQ(bytes_of_records(again), bytes_of_records(file));
}

/// The recording in JSON Lines and back, and packed.
void expect_kept(const std::string& file, const std::string& name) {
    const std::vector<std::uint8_t> records = bytes_of_records(file);
    const std::string text = recording_as_json(file, name);
    const std::string again = recording_of_json(text, name);
    EXPECT_EQ(bytes_of_records(again), records) << name;
    EXPECT_EQ(recording_as_json(again, name), text) << name;
    EXPECT_EQ(bytes_of_records(recording_of(records_of(file))), records) << name;
}

TEST(RecordingJson, KeepsAllThatRecordingsHave) {
    namespace fs = std::filesystem;
    const fs::path source = SCB_SOURCE_DIR;
    std::size_t files = 0;
    for (const fs::path& folder : {source / "tests/fuzz/corpus/recording",
                                   source / "../shared/cases", source / "../shared/hostile"}) {
        if (!fs::is_directory(folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            const std::string name = entry.path().string();
            if (!entry.is_regular_file()) continue;
            const std::string bytes = file_bytes(name);
            if (!starts_as_recording(bytes)) continue;
            try {
                records_of(bytes);
            } catch (const InputError&) {
                continue;  // a fuzzer's
            }
            ++files;
            expect_kept(bytes, name);
        }
    }
    EXPECT_GE(files, 3u);
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
          "{\"query\": [0, 1], \"tags\": [null]}",
          "{\"mesh\": 0, \"coordinate_bytes\": 4, \"coordinates\": [0, 0, "
          "\"nan:7ff0000000000001\"]}",
          "{\"complete\": 256}",
          "{\"complete\": \"yes\"}",
          "{\"frame\": 0, \"appended\": \"0\"}",
          "{\"tests\": [], \"appended\": \"00\"}",
          "{\"unknown\": 200, \"hex\": \"\"}",
          "{\"unknown\": 205, \"hex\": \"\"}",
          "{\"unknown\": 250, \"hex\": \"0\"}",
          "{\"setting\": {\"hex\": \"zz\"}, \"value\": \"\"}"}) {
        const std::string sentence = refusal_of_text(text);
        EXPECT_TRUE(sentence.starts_with("x.jsonl: line 1")) << text << ": " << sentence;
    }
}

TEST(RecordingJson, RefusesATagThatIsNoText) {
    EXPECT_EQ(refusal_of_text("{\"query\": [0, 1], \"tags\": [\"grasp\", null]}"),
              "x.jsonl: line 1: tags[1]: expected a text in quotes, found null.");
}

TEST(RecordingJson, ThatCannotBeOpenedSaysWhy) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.jsonl", "{\"end\": true}");
    EXPECT_EQ(refusal_without_files([&] { recording_bytes(file); }),
              file +
                  ": cannot be opened (Too many open files); raise the limit of open files (ulimit "
                  "-n).");
}

}  // namespace
}  // namespace scb::scenes
