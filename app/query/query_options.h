#pragma once

#include <string>
#include <vector>

#include "app/study/query_setup.h"

namespace scb::app {

class Command;

/// File endings of scenes, meshes in common formats, traces and recordings.
std::vector<std::string> scene_endings();

/// Names of built-in scenes, in the order of `scb scenes`.
std::vector<std::string> builtin_names();

void add_scene_options(const Command& command, SceneOptions& options, bool with_frame);

/// `several`: whether --volume takes a list. With `splits`, --split takes a list of names, which is
/// stored there instead of the one split.
void add_hierarchy_options(const Command& command, HierarchyOptions& options, bool several = true,
                           std::string* splits = nullptr);

/// --test and --threshold; `several_tests`: whether --test takes a list.
void add_overlap_options(const Command& command, QueryOptions& options, bool several_tests);
/// Names that --compare accepts: overlap tests and volumes.
std::vector<std::string> compared_words();
void add_bodies_option(const Command& command, QueryOptions& options);
/// --descent, --frames and --bodies.
void add_traversal_options(const Command& command, QueryOptions& options);
/// The options above and all others of a query.
void add_query_options(const Command& command, QueryOptions& options, bool several_tests);
void add_query_limits(const Command& command, QueryLimits& limits);

/// The options that define a query, which a trace already has.
const std::vector<std::string>& recording_options();
/// The recording_options() that were given.
std::vector<std::string> given_recording_options(const Command& command);
/// The recording_options() given that set how hierarchies are built or the pose of the second mesh.
std::vector<std::string> given_hierarchy_options(const Command& command);
/// Throws InputError if `given` is not empty.
void refuse_for_trace(const std::vector<std::string>& given, const std::string& trace);

}  // namespace scb::app
