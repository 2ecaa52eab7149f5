#pragma once

#include "app/study/scene_query.h"
#include "scenes/recordings/trace_recording.h"

namespace scb::app {

/// A recording of the bodies of a query, without frames yet. `layout`: the name of the packed
/// layout, if SceneQuery::trace_packed was called; else empty.
scenes::TraceRecording recording_of(const SceneOptions& scene, const SceneQuery& query,
                                    const std::string& layout);

/// The query of a frame with its steps.
QueryTrace traced_query(const SceneQuery& query, int frame);

}  // namespace scb::app
