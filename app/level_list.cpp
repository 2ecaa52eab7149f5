#include "app/level_list.h"

#include <algorithm>

#include "app/options.h"
#include "core/error.h"

namespace scb {

std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::string& option_name) {
    const std::string option = option_name + " " + text;
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
        if (part == "auto") {
            for (int level = 0; level <= deepest; ++level) add(level);
            continue;
        }
        if (part == "leaves") {
            add(leaf_level);
            continue;
        }
        const std::vector<std::string> bounds = split_list(part, ':');
        if (bounds.size() > 3)
            throw InputError(option + ": '" + part +
                             "' is no range; give FIRST:LAST or FIRST:LAST:STEP.");
        const std::string hint = "; give levels such as 5,7,9 or 0:12 or leaves.";
        const int first = whole_number(bounds[0], option, hint);
        const int last = bounds.size() > 1 ? whole_number(bounds[1], option, hint) : first;
        const int step = bounds.size() > 2 ? whole_number(bounds[2], option, hint) : 1;
        if (step < 1 || last < first)
            throw InputError(
                option + ": '" + part +
                "' names nothing; give FIRST:LAST[:STEP] with FIRST <= LAST and STEP >= 1.");
        check(first);
        check(last);
        for (long level = first; level <= last; level += step) add(static_cast<int>(level));
    }
    return levels;
}

}  // namespace scb
