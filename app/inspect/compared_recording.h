#pragma once

#include <vector>

#include "app/study/frame_findings.h"
#include "app/study/query_source.h"

namespace scb::app {

/// The part of a recording in which this project's hierarchies make the same queries.
struct ComparedRecording {
    scenes::Scene scene;
    std::size_t a = 0, b = 0;  ///< the bodies
    std::vector<int> frames;
    Work recorded;            ///< in these frames
    std::uint64_t pairs = 0;  ///< the contacts in these frames
};

/// The inspected frames, or evenly spread ones if all would take more than seconds; if the meshes
/// change, the frame with the most volume tests. Throws InputError if the queries cannot be made
/// with hierarchies of this project: objects without meshes, poses that are not rigid, a body
/// against itself, queries that ended early, or no volume tests. `findings`: of all inspected
/// frames.
ComparedRecording compared_recording(const QuerySource& source, const FrameFindings& findings);

}  // namespace scb::app
