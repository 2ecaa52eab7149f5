#pragma once

#include <string>
#include <vector>

#include "app/options.h"
#include "core/collide.h"

namespace scb {

/// What every command that makes collision queries understands, beside the scene and hierarchies.
struct QueryOptions {
    std::string test = "symmetric";
    double threshold = OverlapOptions{}.threshold;
    std::string descent = "radius";
    std::string frames = "all";
    std::string bodies;

    /// The overlap tests named, each once; throws InputError for an unknown name.
    std::vector<OverlapTest> tests() const;
    /// What a query is to do, with the one test named; throws InputError.
    CollideOptions collide() const;
};

/// Notes that `printed` is among the tests, where it is.
void warn_of_printed(const QueryOptions& options, const Console& console);

/// `several_tests`: whether --test takes a list.
void add_query_options(CLI::App& command, QueryOptions& options, bool several_tests);

}  // namespace scb
