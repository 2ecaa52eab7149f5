#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/study/scene_query.h"
#include "scb/packed_hierarchy.h"

namespace scb::app {

/// "float2, float4, ...": the values of --layout except the reference.
std::string layout_names(const std::string& separator = ", ");

/// All values of --layout.
std::vector<std::string> layout_words();

/// The layouts in a list for --layout, with at most `leaf_triangles` triangles in a leaf; nullopt
/// is the reference. Throws InputError if a name is unknown or repeated, or if `leaf_triangles` is
/// not 1 to 4.
std::vector<std::optional<PackedLayout>> layouts_of(const std::string& list, int leaf_triangles);

/// --leaf, for layouts_of.
void add_leaf_option(const Command& command, int& leaf_triangles);

/// The layout of a command's queries.
struct LayoutOptions {
    std::string layout = "reference";
    int leaf_triangles = most_leaf_triangles;

    /// The one layout given; none: the reference. Throws InputError if the volumes have no packed
    /// layout, and if an option was given that has no meaning for packed queries.
    std::optional<PackedLayout> packed(const HierarchyOptions& hierarchy, const QueryOptions& query,
                                       const QueryLimits& limits) const;
    /// Packs the hierarchies of a query. Throws InputError as SceneQuery::pack does, and for a body
    /// with itself.
    void pack(SceneQuery& query, const PackedLayout& as) const;
    /// Notes that --leaf has no effect without a packed layout.
    void note_doubts(const Note& note) const;
};

/// --layout and --leaf.
void add_layout_options(const Command& command, LayoutOptions& options,
                        const std::string& description);

/// The queries of two bodies on packed hierarchies, as a recording in memory; `options` must have a
/// packed layout. Of another engine's recording, the meshes and poses are taken. Ends early if
/// interrupted. Throws InputError as open_query does, and if the scene is a trace.
SceneOptions packed_queries(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                            const QueryOptions& query, const QueryLimits& limits,
                            const LayoutOptions& options, const Console& console,
                            const InterruptWatch& watch);

/// --threads, for check_threads.
void add_threads_option(const Command& command, int& threads, const std::string& description);

/// Throws InputError, naming --threads, if the number is not 1 to 256.
void check_threads(int threads);

}  // namespace scb::app
