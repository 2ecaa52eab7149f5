#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "tests/scenes/recordings/record_everything.h"
#include "tests/scenes/recordings/recording_block.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/temporary_folder.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

std::string refusal_of_bytes(const std::string& bytes) {
    try {
        records_of(bytes);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// The reader of a damaged file returns the records up to some point, or refuses the file.
void expect_part(const std::string& bytes, const std::string& whole) {
    try {
        RecordingReader reader(bytes, "x.scbrec"), other(whole, "x.scbrec");
        while (const Record* record = reader.next()) {
            const Record* expected = other.next();
            ASSERT_NE(expected, nullptr);
            // NaN is not what it is, but its bytes are.
            if (*record != *expected) {
                ASSERT_EQ(recording_of({*record}), recording_of({*expected}));
            }
        }
        EXPECT_EQ(reader.damage().starts_with("x.scbrec "), bytes != whole);
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("x.scbrec")) << error.what();
        EXPECT_TRUE(std::string(error.what()).ends_with(".")) << error.what();
    }
}

TEST(RecordingFile, IsReadAsItWasWritten) {
    const std::string bytes = recording_of(sample_records());
    EXPECT_TRUE(starts_as_recording(bytes));
    std::string damage;
    EXPECT_EQ(recording_of(records_of(bytes, &damage)), bytes);
    EXPECT_EQ(damage, "");
    EXPECT_EQ(records_of(bytes).size(), sample_records().size());
}

TEST(RecordingFile, OfTheRecorderIsPackedWithoutLoss) {
    const TemporaryFolder folder;
    ASSERT_EQ(record_everything((folder / "x.scbrec").c_str()), 0);
    const std::string plain = file_bytes(folder / "x.scbrec"),
                      packed = recording_of(records_of(plain));
    EXPECT_LT(4 * packed.size(), plain.size());
    EXPECT_EQ(records_of(packed), records_of(plain));
}

TEST(RecordingFile, ThatIsCutOffAnywhereIsReadUpToThere) {
    const TemporaryFolder folder;
    ASSERT_EQ(record_everything((folder / "x.scbrec").c_str()), 0);
    const std::string whole = file_bytes(folder / "x.scbrec");
    for (std::size_t size = 0; size < whole.size();
         size += size < 3000 ? 1 : unless_sanitized(997, 9973))
        expect_part(whole.substr(0, size), whole);
}

TEST(RecordingFile, ThatIsDamagedAnywhereIsReadUpToThere) {
    std::string bytes = recording_of(sample_records());
    const std::string whole = bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(bytes[i] ^ 0x10);
        expect_part(bytes, whole);
        bytes[i] = whole[i];
    }
}

TEST(RecordingFile, SaysAtWhichByteItIsDamaged) {
    const std::string start = recording_of({}),
                      block = recording_of({RecordedFrame{3}}).substr(start.size()),
                      second = std::to_string(start.size() + block.size()),
                      all = std::to_string(start.size() + 2 * block.size());
    std::string bytes = start + block + block;
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    std::string damage;
    EXPECT_EQ(records_of(bytes, &damage).size(), 1u);
    EXPECT_EQ(damage, "x.scbrec is damaged or cut off at byte " + second + " of " + all +
                          "; what stands before was read.");
}

/// A mesh whose record, and so its block, is longer than the window of a file.
RecordedMesh long_mesh() {
    RecordedMesh mesh{7, "long", 8, std::vector<double>(900'000), {}};
    for (std::size_t i = 0; i < mesh.coordinates.size(); ++i)
        mesh.coordinates[i] = std::sin(static_cast<double>(i));
    return mesh;
}

TEST(RecordingFile, OnDiskIsReadAsInMemory) {
    std::vector<Record> records = sample_records();
    records.insert(records.end() - 1, long_mesh());
    const std::string whole = recording_of(records);
    ASSERT_GT(whole.size(), 3u << 20);
    std::string damaged = whole;
    damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 1);
    const TemporaryFolder folder;
    const std::string path = folder / "x.scbrec";
    for (const std::string& bytes :
         {whole, whole.substr(0, whole.size() - 1), whole.substr(0, whole.size() / 2), damaged,
          whole.substr(0, 12), whole.substr(0, 15)}) {
        folder.write("x.scbrec", bytes);
        std::string damage, damage_on_disk;
        const std::vector<Record> there =
            records_of(RecordingBytes::of_file(path), &damage_on_disk);
        EXPECT_EQ(recording_of(there), recording_of(records_of(bytes, &damage)));
        EXPECT_EQ(damage_on_disk, damage);
    }
}

TEST(RecordingFile, IsRefusedIfItChangesBetweenTwoReaders) {
    const TemporaryFolder folder;
    const std::string path = folder.write("x.scbrec", recording_of(sample_records()));
    const RecordingBytes bytes = RecordingBytes::of_file(path);
    EXPECT_EQ(records_of(bytes).size(), sample_records().size());
    const auto written = std::filesystem::last_write_time(path);
    const auto expect_refused = [&] {
        try {
            RecordingReader(bytes, path);
            ADD_FAILURE();
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(),
                      path + " changed while it was read; wait until its recorder is done.");
        }
    };
    std::filesystem::last_write_time(path, written + std::chrono::seconds(1));
    expect_refused();
    folder.write("x.scbrec", recording_of({RecordedFrame{3}}));
    std::filesystem::last_write_time(path, written);
    expect_refused();
}

TEST(RecordingFile, IsWrittenInPartsAsAtOnce) {
    std::string parts;
    RecordingWriter writer;
    std::size_t before_the_end = 0;
    for (int i = 0; i < 3; ++i) {
        writer.add(long_mesh());
        parts += writer.take();
        before_the_end = parts.size();
    }
    parts += writer.finish();
    EXPECT_EQ(parts, recording_of({long_mesh(), long_mesh(), long_mesh()}));
    EXPECT_GT(before_the_end, parts.size() / 2);
}

TEST(RecordingFile, RefusesWhatIsNone) {
    EXPECT_EQ(refusal_of_bytes(""),
              "x.scbrec is no recording, which scb_record.h writes; name one (.scbrec).");
    std::string newer = recording_of(sample_records());
    newer[8] = 2;
    EXPECT_EQ(refusal_of_bytes(newer),
              "x.scbrec is a recording of version 2; this scb reads versions up to 1: update it.");
    newer[8] = 0;
    EXPECT_TRUE(refusal_of_bytes(newer).starts_with("x.scbrec is a recording of version 0;"));
}

TEST(RecordingFile, RefusesRecordsThatContradictThemselves) {
    using std::string_literals::operator""s;
    for (const std::string& payload :
         {"\x01"s,                                  // a test without nodes
          "\xc0\x08\x00\x00\x00\x04"s,              // longer than its block
          "\xc0\x04\x00\x00\x00\xff\xff\xff\xff"s,  // a text as long
          // A mesh of coordinates of five bytes, and one of so many that three times that is 2 in
          // 32 bits.
          "\xc2\x11\x00\x00\x00\0\0\0\0\0\0\0\0\x05\0\0\0\0\0\0\0\0"s,
          "\xc2\x21\x00\x00\x00\0\0\0\0\0\0\0\0\x08\x56\x55\x55\x55\0\0\0\0"s +
              std::string(16, '\0'),
          "\xc5\x0d\x00\x00\x00\0\0\0\0\0\0\0\0\x0a\0\0\0\0"s}) {  // kind 10
        const std::string sentence = refusal_of_bytes(recording_with_block(payload));
        EXPECT_TRUE(sentence.starts_with("x.scbrec: ")) << sentence;
        EXPECT_NE(sentence.find("in the block at byte 12"), std::string::npos) << sentence;
    }
    EXPECT_NE(refusal_of_bytes(recording_with_block("\xff\xff\xff\xff\x01", "pack")), "")
        << "4 GiB of nothing";
    EXPECT_EQ(refusal_of_bytes(recording_with_block("anything", "none")), "")
        << "blocks of other kinds can be left out";
    const std::string start = recording_of({}),
                      behind = recording_of({RecordedFrame{3}}).substr(start.size());
    for (const std::string& left_out :
         {recording_with_block("anything", "none"), recording_with_block("")})
        EXPECT_EQ(records_of(left_out + behind), std::vector<Record>{RecordedFrame{3}});
    EXPECT_EQ(records_of(recording_with_block("\xcb\x02\x00\x00\x00\x01\x02"s)),
              std::vector<Record>{appended(RecordedEnd{}, {1, 2})})
        << "what a newer version adds to a record";
}

}  // namespace
}  // namespace scb::scenes
