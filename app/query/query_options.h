#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/query/scene_options.h"
#include "scb/collide.h"

namespace scb::app {

/// Options of every command that makes collision queries, besides the options of scene and
/// hierarchies.
struct QueryOptions {
    std::string test{overlap_test_name(OverlapOptions{}.test)};
    double threshold = OverlapOptions{}.threshold;
    DescentRule descent = CollideOptions{}.descent;
    std::string frames = "all";
    std::string bodies{};

    /// The overlap tests named, each once; throws InputError for an unknown name.
    std::vector<OverlapTest> tests() const;
    /// The one test named, and its threshold; throws InputError.
    OverlapOptions overlap() const;
    /// The options of a query with that test; throws InputError.
    CollideOptions collide() const;
};

/// Limits at which a query ends before it has found everything.
struct QueryLimits {
    std::int64_t max_pairs = 100'000'000;
    std::string levels{};  ///< one level; empty: none

    /// Sets CollideOptions::max_pairs and stop_level. Throws InputError if the number of pairs is
    /// below 1, or the level does not exist. `deepest_level`: the scene's.
    void apply(CollideOptions& options, int deepest_level) const;
};

/// Notes surprising options: `printed` among the tests, and options without effect on hierarchies
/// of these kinds.
void note_doubts(const QueryOptions& options, const std::vector<VolumeKind>& kinds,
                 const Console& console);

/// --test and --threshold; `several_tests`: whether --test takes a list.
void add_overlap_options(const Command& command, QueryOptions& options, bool several_tests);
/// Names that --compare accepts: overlap tests and volumes.
std::vector<std::string> compared_words();
void add_bodies_option(const Command& command, QueryOptions& options);
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
/// Whether a recording is to be shown as recorded: no given option sets how hierarchies are built
/// or tested. Otherwise its meshes and poses are used as a scene.
bool asks_for_recorded(const std::vector<std::string>& given);

}  // namespace scb::app
