#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// The record as a newer version has it, with these bytes behind what is known of it.
inline Record appended(Record record, std::vector<std::uint8_t> bytes) {
    record.appended = std::move(bytes);
    return record;
}

/// One of each kind of record, and some whose numbers and texts are hard to keep.
inline std::vector<Record> sample_records() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Record> records = {
        RecordedSetting{"engine", "test"},
        RecordedStage{1, "axis \"A\"\n"},
        RecordedStage{2, "\xff\xfe no UTF-8"},
        RecordedMesh{1, "m\u00fcsh", 4, {0, 0, 0, 1, 0, 0, 0, 0.1f, 1e-40f}, {0, 1, 2}},
        RecordedMesh{2,
                     "",
                     8,
                     {0.1, -0.0, 5e-324, 1.7976931348623157e308, -infinity, infinity},
                     {0, 1, UINT32_MAX}},
        RecordedTree{0, 1, "t", {}},
        RecordedTree{1, record_none, "k", {1, 0, 0, 0.6, 0.8, 0}},
        RecordedNode{0, 0, record_none, UINT64_MAX, "root", {1, 2}, {}, {RecordedKind::none, {}}},
        RecordedNode{0, 1, 0, 1, "", {}, {0, 5, record_none}, {RecordedKind::hull, {1, 2, 3}}},
        RecordedRefit{0, 1, {RecordedKind::ball, {nan, -nan, infinity, -0.0}}},
        RecordedBody{0, 0, "A"},
        RecordedFrame{0},
        RecordedPose{0, {1, 0, 0, 1e-300, 0, 1, 0, 1.0 / 3, 0, 0, 1, 1e22}},
        RecordedQuery{0, 0},
        RecordedEvent{0, 1, 2},
        RecordedEvent{127, UINT32_MAX, 2},
        RecordedEvent{static_cast<std::uint8_t>(RecordTag::items_apart), 1, 2},
        RecordedEvent{static_cast<std::uint8_t>(RecordTag::items_meet), 1, 2},
        RecordedEvent{static_cast<std::uint8_t>(RecordTag::pair), 1, 2},
        RecordedEvent{static_cast<std::uint8_t>(RecordTag::parent), 1, 2},
        RecordedEvent{191, 1, 2},
        RecordedMeasure{1, infinity, 0.1},
        RecordedMeasure{200, nan, -0.0},
        recorded_length(0.1),
        recorded_length(-nan),
        RecordedAnswer{1.0 / 3, 4, record_none, {1, 2, 3, 4, 5, infinity}},
        RecordedAnswer{nan, record_none, record_none, {}},
        RecordedQueryEnd{0, UINT64_MAX},
        RecordedQueryEnd{2, 0},
        RecordedQueryEnd{255, 0},
        RecordedUnknown{250, {0, 1, 255}},
        appended(RecordedFrame{1}, {0}),
        appended(RecordedPose{0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, {1, 2, 3}),
        appended(RecordedNode{0, 2, 0, 2, "", {}, {1}, {RecordedKind::none, {}}}, {255, 0}),
        appended(RecordedMesh{3, "", 4, {}, {}}, {7}),
        appended(RecordedSetting{"key", "value"}, {0x22}),
        appended(RecordedQueryEnd{}, {9})};
    for (std::uint32_t i = 0; i < 1000; ++i) records.emplace_back(RecordedEvent{1, i, i / 2});
    records.emplace_back(RecordedEnd{});
    return records;
}

inline std::string recording_of(const std::vector<Record>& records) {
    RecordingWriter writer;
    for (const Record& record : records) writer.add(record);
    return writer.finish();
}

/// `bytes`: a text, or RecordingBytes.
template <class Bytes>
std::vector<Record> records_of(const Bytes& bytes, std::string* damage = nullptr) {
    RecordingReader reader(bytes, "x.scbrec");
    std::vector<Record> records;
    while (const Record* record = reader.next()) records.push_back(*record);
    if (damage) *damage = reader.damage();
    return records;
}

}  // namespace scb::scenes
