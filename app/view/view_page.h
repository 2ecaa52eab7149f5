#pragma once

#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/pictures/level_options.h"
#include "app/query/query_options.h"

namespace scb::app {

/// What a page of `scb view` is asked to be: its first level and look, its camera, and its
/// still picture as LevelOptions have them, and what is in it.
struct ViewOptions {
    LevelOptions level;
    QueryOptions query;
    std::string queries = "auto";          ///< see ViewSources::queries
    std::string compare{};                 ///< see CompareOptions::names
    std::vector<std::string> recording{};  ///< see CompareOptions::given
    int steps = 1000;                      ///< see view_query_json
    // As given_text has it, what was given: where the scene is, which bodies, the volumes, other
    // things of hierarchies, of levels alone, and of queries alone.
    std::string scene{}, bodies{}, volumes{}, hierarchies{}, levels{}, queries_asked{};

    /// Refuses what makes no sense before any work is done; throws InputError.
    void check() const;
};

/// The page, as HTML. Throws InputError.
std::string view_page(const ViewOptions& options, const Console& console);

}  // namespace scb::app
