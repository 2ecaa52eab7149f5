#include "app/level_list.h"

#include <algorithm>

#include "app/options.h"
#include "core/error.h"

namespace scb {
std::vector<int> parse_levels(const std::string& text, int deepest) {
    const std::string option = "--levels " + text;
    std::vector<int> levels;
    const auto add = [&levels](int level) {
        if (std::find(levels.begin(), levels.end(), level) == levels.end()) levels.push_back(level);
    };
    const auto check = [&](int level) {
        if (level < 0 || level > deepest)
            throw InputError(option + ": there is no level " + std::to_string(level) +
                             "; this scene's hierarchies have the levels 0 to " +
                             std::to_string(deepest) + ", and 'leaves'.");
    };
    for (const std::string& part : split_list(text, ',')) {
        if (part == "leaves") {
            add(leaf_level);
            continue;
        }
        const std::vector<std::string> bounds = split_list(part, ':');
        if (bounds.size() > 3)
            throw InputError(option + ": '" + part +
                             "' is no range; give FIRST:LAST or FIRST:LAST:STEP.");
        const int first = whole_number(bounds[0], option);
        const int last = bounds.size() > 1 ? whole_number(bounds[1], option) : first;
        const int step = bounds.size() > 2 ? whole_number(bounds[2], option) : 1;
        if (step < 1 || last < first)
            throw InputError(
                option + ": '" + part +
                "' names nothing; give FIRST:LAST[:STEP] with FIRST <= LAST and STEP >= 1.");
        check(first);
        check(last);
        for (int level = first; level <= last; level += step) add(level);
    }
    return levels;
}

std::string level_name(int level) { return level == leaf_level ? "leaves" : std::to_string(level); }

}  // namespace scb
