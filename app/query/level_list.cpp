#include "app/query/level_list.h"

#include <algorithm>

#include "scb/error.h"
#include "scenes/text/number_list.h"

namespace scb::app {

std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::vector<int>& automatic) {
    const std::string option = "--levels " + text;
    std::vector<int> levels;
    const auto add = [&levels](int level) {
        if (std::find(levels.begin(), levels.end(), level) == levels.end()) levels.push_back(level);
    };
    const scenes::NumberRange range{option, "level", "this scene's hierarchies have", deepest,
                                    "levels such as 5,7,9 or 0:12 or leaves"};
    for (const std::string& part : scenes::split_list(text, ',')) {
        if (part == "auto") {
            for (const int level : automatic) add(level);
            continue;
        }
        if (part == "all") {
            for (int level = 0; level <= deepest; ++level) add(level);
            continue;
        }
        if (part == "leaves") {
            add(leaf_level);
            continue;
        }
        for (const int level : scenes::parse_numbers(part, range)) add(level);
    }
    return levels;
}

int parse_level(const std::string& text, int deepest) {
    const std::vector<int> levels = parse_levels(text, deepest);
    if (levels.size() != 1)
        throw InputError("--levels " + text + ": this command takes one level; give one.");
    return levels[0];
}

}  // namespace scb::app
