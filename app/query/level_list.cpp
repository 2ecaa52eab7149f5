#include "app/query/level_list.h"

#include <set>

#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {

std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::vector<int>& automatic, const std::string& name) {
    const std::string option = name + " " + text;
    std::vector<int> levels;
    std::set<int> seen;
    const auto add = [&](int level) {
        if (seen.insert(level).second) levels.push_back(level);
    };
    const NumberRange range{option, "level", "this scene's hierarchies have", deepest,
                            "levels such as 5,7,9 or 0:12 or leaves"};
    for (const std::string& part : split_list(text, ',')) {
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
        for (const int level : parse_numbers(part, range)) add(level);
    }
    return levels;
}

int parse_level(const std::string& text, int deepest, const std::string& name) {
    const std::vector<int> levels = parse_levels(text, deepest, {}, name);
    if (levels.size() != 1)
        throw InputError(name + " " + text + ": this command takes one level; give one.");
    return levels[0];
}

}  // namespace scb::app
