#include "app/query/layout_options.h"

#include <set>

#include "app/cli/validators.h"
#include "app/query/query_options.h"
#include "core/platform/near_word.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scb/packed_hierarchy.h"

namespace scb::app {

std::string layout_names(const std::string& separator) {
    std::string names;
    for (const PackedLayout& layout : all_packed_layouts())
        names += (names.empty() ? "" : separator) + packed_layout_name(layout);
    return names;
}

std::vector<std::string> layout_words() { return split_list("reference," + layout_names(",")); }

std::vector<std::optional<PackedLayout>> layouts_of(const std::string& list, int leaf_triangles) {
    if (leaf_triangles < 1 || leaf_triangles > most_leaf_triangles)
        throw InputError("--leaf " + std::to_string(leaf_triangles) + ": give 1 to " +
                         std::to_string(most_leaf_triangles) + ".");
    std::vector<std::optional<PackedLayout>> result;
    const std::vector<std::string> names = split_list(list);
    std::set<std::string> known;
    for (const std::string& name : names) {
        std::optional<PackedLayout> layout = packed_layout_of(name);
        if (!layout && name != "reference")
            throw InputError("--layout " + list + ": '" + name + "' is not a layout" +
                             did_you_mean(name, layout_words()) + "; give some of reference, " +
                             layout_names() + ".");
        if (!known.insert(name).second)
            throw InputError("--layout " + list + ": '" + name +
                             "' is there twice; give each layout once.");
        if (layout) layout->leaf_triangles = leaf_triangles;
        result.push_back(layout);
    }
    return result;
}

void add_leaf_option(const Command& command, int& leaf_triangles) {
    command.add_option("--leaf", leaf_triangles, "Triangles of a packed leaf, at most: 1 to 4")
        .check(decimal_number)
        .type_name("N")
        .show_default()
        .shareable();
}

void add_threads_option(const Command& command, int& threads, const std::string& description) {
    command.add_option("--threads", threads, description)
        .check(decimal_number)
        .type_name("N")
        .show_default()
        .shareable();
}

void check_threads(int threads) {
    if (threads < 1 || threads > 256)
        throw InputError("--threads " + std::to_string(threads) + ": give 1 to 256.");
}

}  // namespace scb::app
