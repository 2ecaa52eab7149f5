#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/inspect/inspect_options.h"
#include "app/inspect/inspect_pictures.h"
#include "app/inspect/inspect_report.h"
#include "app/shards/parts.h"
#include "app/study/frame_findings.h"
#include "app/study/query_sources.h"

namespace scb::app {

/// The queries to inspect, and all that is found about them.
struct InspectedQueries {
    std::shared_ptr<const scenes::RecordingFile> file;   ///< null unless a recording
    std::shared_ptr<const scenes::Recording> recording;  ///< null if it has no tree
    QuerySources sources;  ///< one; none for a recording without queries of two chosen bodies
    std::string no_waste;  ///< why there is none: a sentence
    std::vector<int> frames;
    std::size_t done = 0;  ///< of the frames
    std::optional<FrameFindings> found;
    InspectReport report;
};

/// Opens the recorded queries in the options. Without two chosen bodies, only the recording. Throws
/// InputError.
InspectedQueries open_recording(const InspectOptions& options);
/// Opens the queries of a scene or a trace. Throws InputError.
InspectedQueries open_scene(const InspectOptions& options, const Console& console);

/// Judges the recording, and attributes the tests of the two bodies on the way. Throws InputError.
void judge(InspectedQueries& inspected, const InspectOptions& options, const Console& console,
           const InterruptWatch& watch);
/// Makes or reads the queries of a scene frame by frame, until interrupted.
void inspect_frames(InspectedQueries& inspected, const InspectOptions& options, Parts& parts,
                    const Console& console, const InterruptWatch& watch);

/// Takes the findings over into the report. Returns the explanations of its pairs.
ExplainedPairs report_waste(InspectedQueries& inspected);

/// Whether other settings can be compared with the queries: not with partial queries, with
/// deliberate errors, or with queries that miss contacts.
bool can_compare(const InspectedQueries& inspected);
/// Whether other methods can be compared with queries of distances.
bool can_compare_distances(const InspectedQueries& inspected);

}  // namespace scb::app
