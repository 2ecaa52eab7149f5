#pragma once

#include <algorithm>

#include "core/analysis/attribution.h"
#include "scenes/recordings/recording_judgement.h"
#include "scenes/recordings/trace_recording.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"
#include "tests/scenes/recordings/small_records.h"

namespace scb::scenes {

inline const BuiltMesh& mesh_a() {
    static const BuiltMesh built(random_soup(1, 120, 0.15));
    return built;
}
inline const BuiltMesh& mesh_b() {
    static const BuiltMesh built(random_soup(2, 100, 0.15));
    return built;
}

inline Trace trace_of(VolumeKind volume, OverlapTest test = OverlapTest::corrected) {
    return record_trace(mesh_a(), mesh_b(), asking(volume, test), {0, 3, 6});
}

inline std::string recording_of(const Trace& trace) {
    const auto kind = static_cast<std::size_t>(trace.header.volume);
    TraceRecording recording(trace.header,
                             {TracedBody{&mesh_a().mesh, &mesh_a().hierarchies[kind]},
                              TracedBody{&mesh_b().mesh, &mesh_b().hierarchies[kind]}});
    for (const QueryTrace& frame : trace.frames) recording.add(frame, {Pose{}, frame.b_to_a});
    return recording.finish();
}

inline std::vector<Record> records_in(const std::string& bytes) {
    std::vector<Record> records;
    RecordingReader reader(bytes, "test");
    while (const Record* record = reader.next()) records.push_back(*record);
    return records;
}

inline constexpr auto items_apart = static_cast<std::uint8_t>(RecordTag::items_apart),
                      items_meet = static_cast<std::uint8_t>(RecordTag::items_meet),
                      a_pair = static_cast<std::uint8_t>(RecordTag::pair);

inline std::vector<RecordedPose*> poses_of_b(std::vector<Record>& records) {
    std::vector<RecordedPose*> poses;
    for (Record& record : records)
        if (auto* pose = std::get_if<RecordedPose>(&record); pose && pose->body == 1)
            poses.push_back(pose);
    return poses;
}

inline RecordingJudgement judge(const std::string& bytes) {
    return judge_recording(
        {bytes, "test.scbrec"}, [](int) { return true; }, [](bool) { return true; });
}

inline RecordingJudgement judge(const std::vector<Record>& records) {
    RecordingWriter writer;
    for (const Record& record : records) writer.add(record);
    return judge(writer.finish());
}

/// The reasons why parts are not judged.
inline std::string not_judged(const RecordingJudgement& judged) {
    std::string all;
    for (const NotJudged& part : judged.not_judged)
        all += std::to_string(part.count) + " " + part.what + ": " + part.why + "\n";
    return all;
}

/// What was not judged of this kind.
inline const NotJudged* part_of(const RecordingJudgement& judged, const std::string& what) {
    const auto found = std::find_if(judged.not_judged.begin(), judged.not_judged.end(),
                                    [&what](const NotJudged& part) { return part.what == what; });
    return found == judged.not_judged.end() ? nullptr : &*found;
}

}  // namespace scb::scenes
