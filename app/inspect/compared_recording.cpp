#include "app/inspect/compared_recording.h"

#include <algorithm>
#include <map>

#include "app/study/tune_run.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {

ComparedRecording compared_recording(const QuerySource& source, const FrameFindings& findings) {
    const scenes::Recording& recording = source.recorded()->recording();
    const std::string& path = recording.file->path;
    if (source.header().engine->objects)
        throw InputError(path + ": its items are objects without triangles.");
    if (source.body_index(0) == source.body_index(1))
        throw InputError(path + ": its queries are of a body against itself.");
    if (const std::optional<int> frame = source.recorded()->ended_early())
        throw InputError(path + ": the query of frame " + std::to_string(*frame) +
                         " ended early on purpose, so its tests cannot be compared; select whole "
                         "queries with --frames, --query or --tag.");
    if (!recording.refusal.empty() && !recording.changes_meshes)
        throw InputError(recording.refusal);
    std::vector<std::pair<int, Work>> of_frames;
    std::map<int, std::uint64_t> pairs_of;
    Work all;
    for (const InspectedFrame& frame : findings.frames) {
        of_frames.emplace_back(frame.frame, frame.found.counts.all);
        pairs_of[frame.frame] = frame.found.pairs;
        all += of_frames.back().second;
    }
    if (all.volume_tests == 0) throw InputError(path + ": no tests of volumes were recorded.");
    std::sort(of_frames.begin(), of_frames.end());
    std::vector<std::size_t> places = counted_frames(of_frames.size(), all);
    // Hierarchies of this project have one mesh, so only one frame can be used.
    if (recording.changes_meshes)
        places = {static_cast<std::size_t>(
            std::max_element(of_frames.begin(), of_frames.end(),
                             [](const auto& x, const auto& y) { return x.second < y.second; }) -
            of_frames.begin())};
    ComparedRecording compared;
    compared.a = source.body_index(0);
    compared.b = source.body_index(1);
    for (const std::size_t i : places) {
        compared.pairs += pairs_of[of_frames[i].first];
        compared.frames.push_back(of_frames[i].first);
        compared.recorded += of_frames[i].second;
    }
    compared.scene =
        recording.changes_meshes ? scenes::scene_at(recording, compared.frames[0]) : source.scene();
    return compared;
}

}  // namespace scb::app
