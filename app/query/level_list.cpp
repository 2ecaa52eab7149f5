#include "app/query/level_list.h"

#include <algorithm>

#include "app/query/scene_options.h"
#include "scenes/text/number_list.h"

namespace scb {

std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::string& option_name) {
    const std::string option = option_name + " " + text;
    std::vector<int> levels;
    const auto add = [&levels](int level) {
        if (std::find(levels.begin(), levels.end(), level) == levels.end()) levels.push_back(level);
    };
    const NumberRange range{option, "level", "this scene's hierarchies have", deepest,
                            "levels such as 5,7,9 or 0:12 or leaves"};
    for (const std::string& part : split_list(text, ',')) {
        if (part == "auto") {
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

}  // namespace scb
