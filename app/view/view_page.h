#pragma once

#include <string>
#include <vector>

#include "app/pictures/level_options.h"
#include "app/query/distance_options.h"
#include "app/study/query_setup.h"

namespace scb::app {

class Command;
struct Console;

/// Options of a page of `scb view`. `level` has its first level, look, camera and still picture.
struct ViewOptions {
    LevelOptions level;
    QueryOptions query;
    std::string queries = "auto";  ///< see ViewSources::queries
    std::string compare{};         ///< see CompareOptions::names
    KindOptions kind{};
    int steps = 1000;        ///< see view_query_json
    bool has_theme = false;  ///< whether the user set light or dark
    /// Names of the files in commands, if the files will be elsewhere.
    std::vector<std::string> names_in_commands{};
    // Options that were given, see given_text: of the scene, of bodies, other options of
    // hierarchies, of levels only, of overlap tests, and of the descent.
    // For distances: their options.
    std::string scene{}, bodies{}, hierarchies{}, levels{}, tests{}, descent{}, distances{};
    /// Of packed queries: the scene and its hierarchies, and the layout.
    std::string of_packed{}, layout{};

    /// Sets these texts except `levels` and `descent`, and sets `has_theme`.
    void note_given(const Command& command);
    bool has_two_scenes() const;
    /// Refuses invalid options before any work is done; throws InputError.
    void check() const;
};

/// The page, as HTML. Throws InputError.
std::string view_page(const ViewOptions& options, const Console& console);

}  // namespace scb::app
