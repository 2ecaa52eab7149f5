#include "app/query/layout_options.h"

#include <set>

#include "app/cli/progress.h"
#include "app/cli/validators.h"
#include "app/query/query_options.h"
#include "app/study/recorded_query.h"
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

std::optional<PackedLayout> LayoutOptions::packed(const HierarchyOptions& hierarchy,
                                                  const QueryOptions& query,
                                                  const QueryLimits& limits) const {
    const auto layouts = layouts_of(layout, leaf_triangles);
    if (layouts.size() != 1) throw InputError("--layout " + layout + ": give one layout.");
    if (!layouts.front()) return std::nullopt;
    const QueryOptions defaults;
    for (const auto& [name, is_given] :
         {std::pair("--test", query.test != defaults.test),
          std::pair("--threshold", query.threshold != defaults.threshold),
          std::pair("--descent", query.descent != defaults.descent),
          std::pair("--levels", !limits.levels.empty()),
          std::pair("--max-pairs", limits.max_pairs != QueryLimits{}.max_pairs),
          std::pair("--mutation", hierarchy.mutation != Mutation::none)})
        if (is_given)
            throw InputError("--layout " + layout + ": " + name +
                             " is of the reference only; leave one of them out.");
    if (hierarchy.kinds().size() != 1)
        throw InputError("--layout " + layout + ": --volume " + hierarchy.volumes +
                         " names several; give --volume scb or scb2.");
    if (!can_pack(hierarchy.kind()))
        throw InputError("--layout " + layout + ": " +
                         std::string(volume_kind_name(hierarchy.kind())) +
                         " volumes have no packed layout; give --volume scb or scb2.");
    return layouts.front();
}

void LayoutOptions::pack(SceneQuery& query, const PackedLayout& as) const {
    for (const BodyPair& pair : query.pairs)
        if (pair[0] == pair[1])
            throw InputError("--layout " + layout +
                             ": packed queries are of two bodies; for a body with itself, "
                             "leave --layout out.");
    query.pack(as);
}

void LayoutOptions::note_doubts(const Note& note) const {
    if (layout == "reference" && leaf_triangles != most_leaf_triangles)
        note("scb: --leaf has no effect here: it is of packed layouts; name one with --layout.");
}

void add_layout_options(const Command& command, LayoutOptions& options,
                        const std::string& description) {
    command.add_option("--layout", options.layout, description + ": reference, " + layout_names())
        .offer(layout_words())
        .type_name("LAYOUT")
        .show_default()
        .shareable();
    add_leaf_option(command, options.leaf_triangles);
}

SceneOptions packed_queries(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                            const QueryOptions& query, const QueryLimits& limits,
                            const LayoutOptions& options, const Console& console,
                            const InterruptWatch& watch) {
    const std::optional<PackedLayout> layout = options.packed(hierarchy, query, limits);
    if (scene.is_trace())
        throw InputError("--layout " + options.layout + ": " + scene.names[0] +
                         " is a trace of queries already; give its scene, or leave --layout out.");
    SceneQuery queries = open_query(scene, hierarchy, query, limits);
    note_doubts(hierarchy, {queries.kind}, console.notes());
    note_doubts(scene, queries.scene, query, {queries.kind}, console.notes());
    options.pack(queries, *layout);
    queries.trace_packed();
    scenes::TraceRecording recording = recording_of(scene, queries, options.layout);
    Progress progress(console, queries.frames.size());
    for (const int frame : queries.frames) {
        if (watch.signal() != 0) break;
        recording.add(traced_query(queries, frame), queries.poses(frame));
        progress.step("queries");
    }
    SceneOptions packed = scene;
    packed.names = {queries.scene.name};
    packed.pose.clear();
    packed.poses.clear();
    packed.given = std::make_shared<const scenes::Scene>(queries.scene);
    packed.recorded =
        std::make_shared<const scenes::RecordingFile>(recording.finish(), packed.names[0]);
    return packed;
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
