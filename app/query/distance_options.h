#pragma once

#include "app/study/query_setup.h"

namespace scb::app {

class Command;

/// Sets the volumes and the split with which distances are found quickest, and asks for the
/// distance.
void set_distance_defaults(HierarchyOptions& hierarchy, QueryOptions& query);

/// --order, --within, --relative-error and --limit.
void add_distance_options(const Command& command, DistanceQuery& query);

/// Throws InputError for numbers out of range, and for options that --within excludes.
void check_distance(const DistanceQuery& query);

}  // namespace scb::app
