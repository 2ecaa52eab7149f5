#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/query/query_source.h"

namespace scb::app {

/// The queries that a picture shows: one, or two that are compared.
using QuerySources = std::vector<QuerySource>;
/// The same at one frame.
using QueryFrames = std::vector<const TraceFrame*>;

/// What to compare, and what must therefore be left open.
struct CompareOptions {
    std::string names;               ///< two overlap tests or two volumes: "corrected,printed"
    std::vector<std::string> given;  ///< the options that were given, see given_recording_options
};

/// One query of a scene or a trace; two where `compare` names two; or those of two traces of one
/// scene. Notes what may surprise. Throws InputError.
QuerySources open_sources(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                          const QueryOptions& query, const QueryLimits& limits,
                          const CompareOptions& compare, const Console& console);

/// What tells the scenes of queries, with the poses of their frames, from others.
nlohmann::ordered_json subject_of(const QuerySources& sources);

/// What two queries are called where they are compared: by what was asked differently.
struct QueryLabel {
    std::string caption;  ///< "corrected"; "ball (Ritter), descent by area"
    std::string name;     ///< the same for file names and scripts: "corrected", "ritter-area"
};
std::array<QueryLabel, 2> query_labels(const TraceHeader& a, const TraceHeader& b);

}  // namespace scb::app
