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
    std::string queries = "auto";  ///< see ViewSources::queries
    std::string compare{};         ///< see CompareOptions::names
    int steps = 1000;              ///< see view_query_json
    bool has_theme = false;        ///< whether light or dark was asked for
    /// What commands call the files, where these lie elsewhere by then.
    std::vector<std::string> told_names{};
    // As given_text has it, what was given: where the scene is, which bodies, other things of
    // hierarchies, of levels alone, overlap tests, and which nodes queries divide.
    std::string scene{}, bodies{}, hierarchies{}, levels{}, tests{}, descent{};

    /// Sets these texts but for `levels` and `descent`, and `has_theme`.
    void note_given(const Command& command);
    bool has_two_scenes() const;
    /// Refuses what makes no sense before any work is done; throws InputError.
    void check() const;
};

/// The page, as HTML. Throws InputError.
std::string view_page(const ViewOptions& options, const Console& console);

}  // namespace scb::app
