#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/query/scene_options.h"
#include "scb/collide.h"

namespace scb::app {

/// What every command that makes collision queries understands, beside the scene and hierarchies.
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
    /// What a query is to do, with that test; throws InputError.
    CollideOptions collide() const;
};

/// Where a query ends before it has found everything.
struct QueryLimits {
    std::int64_t max_pairs = 100'000'000;
    std::string levels{};  ///< one level; empty: none

    /// Sets CollideOptions::max_pairs and stop_level. Throws InputError where the number of pairs
    /// is below 1, or there is no such level. `deepest_level` is the scene's.
    void apply(CollideOptions& options, int deepest_level) const;
};

/// Notes what of the options may surprise: that `printed` is among the tests, and which of them
/// have no effect on hierarchies of these kinds.
void note_doubts(const QueryOptions& options, const std::vector<VolumeKind>& kinds,
                 const Console& console);

/// --test and --threshold; `several_tests`: whether --test takes a list.
void add_overlap_options(const Command& command, QueryOptions& options, bool several_tests);
/// What can stand side by side: overlap tests and volumes.
std::vector<std::string> compared_words();
void add_bodies_option(const Command& command, QueryOptions& options);
/// These and the rest.
void add_query_options(const Command& command, QueryOptions& options, bool several_tests);
void add_query_limits(const Command& command, QueryLimits& limits);

/// The options that say what a query is to be: a trace already knows.
const std::vector<std::string>& recording_options();
/// Those of them that were given.
std::vector<std::string> given_recording_options(const Command& command);
/// Those of them that say how hierarchies are built and where the second mesh is.
std::vector<std::string> given_hierarchy_options(const Command& command);
/// Throws InputError where there are any.
void refuse_for_trace(const std::vector<std::string>& given, const std::string& trace);
/// Whether a recording is meant as it was recorded: nothing was given that says how hierarchies are
/// built or tested. Else its meshes and poses are a scene like any other.
bool asks_for_recorded(const std::vector<std::string>& given);

}  // namespace scb::app
