#pragma once

#include <initializer_list>

#include "app/cli/command.h"
#include "app/study/query_setup.h"

namespace scb::app {

/// Sets the volumes and the split with which distances are found quickest, and asks for the
/// distance.
void set_distance_defaults(HierarchyOptions& hierarchy, QueryOptions& query);

/// --order, --within, --relative-error and --limit.
void add_distance_options(const Command& command, DistanceQuery& query);

/// The kind of query, of commands that make queries of several kinds.
struct KindOptions {
    QueryKind kind = QueryKind::collide;
    DistanceQuery distance;

    /// Sets QueryOptions::distance. Throws InputError as check_distance does, and for options of
    /// distances without --kind distance.
    void apply(QueryOptions& query) const;
};

/// --kind, and the options of add_distance_options.
void add_kind_options(const Command& command, KindOptions& options);

/// Applies the kind to a command whose queries are of overlap by default, with volumes and split
/// for distances unless they were chosen. `of_overlap`: options of the command that a query of
/// distances does not have. Throws InputError as KindOptions::apply does, for these options, and if
/// the input is a recording, which has its kind.
void take_kind(const Command& command, std::initializer_list<const char*> of_overlap,
               const SceneOptions& scene, HierarchyOptions& hierarchy, QueryOptions& query,
               const KindOptions& options);

/// Throws InputError for numbers out of range, and for options that --within excludes.
void check_distance(const DistanceQuery& query);

}  // namespace scb::app
