#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/study/query_source.h"

namespace scb::app {

/// The queries that a picture shows: one, or two that are compared.
using QuerySources = std::vector<QuerySource>;
/// The same queries at one frame.
using QueryFrames = std::vector<const QueryTrace*>;

/// What to compare, and the options given, which must not set the same.
struct CompareOptions {
    std::string names;               ///< two overlap tests or two volumes: "corrected,printed"
    std::vector<std::string> given;  ///< the options that were given, see given_recording_options
};

/// One query of a scene or a trace; two if `compare` names two, or of two traces of one scene.
/// Notes surprising options. Throws InputError.
QuerySources open_sources(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                          const QueryOptions& query, const QueryLimits& limits,
                          const CompareOptions& compare, const Note& note);

/// Identifies the scenes of queries, with the poses of their frames.
nlohmann::ordered_json subject_of(const QuerySources& sources);

/// Names of two compared queries, from the options in which they differ.
struct QueryLabel {
    std::string caption;  ///< "corrected"; "ball (Ritter), descent by area"
    std::string name;     ///< the same for file names and scripts: "corrected", "ritter-area"
};
std::array<QueryLabel, 2> query_labels(const TraceHeader& a, const TraceHeader& b);

}  // namespace scb::app
