#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/query/layout_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/report/stats_report.h"
#include "core/analysis/hierarchy_measures.h"
#include "core/base/exit_status.h"
#include "core/geometry/mesh_facts.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/model/level_statistics.h"
#include "render/figures/figure_words.h"
#include "scb/any_packed.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct StatsOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    std::string layouts = layout_names(",");
    int leaf_triangles = most_leaf_triangles, threads = 1;
    bool measures = false, json = false, csv = false;
    std::vector<std::string> recording;  ///< see given_hierarchy_options
};

/// The layouts in --layout.
std::vector<PackedLayout> packed_layouts(const StatsOptions& options) {
    std::vector<PackedLayout> result;
    for (const auto& layout : layouts_of(options.layouts, options.leaf_triangles)) {
        if (!layout)
            throw InputError("--layout " + options.layouts +
                             ": the table above is of the reference; name packed layouts alone.");
        result.push_back(*layout);
    }
    return result;
}

void add_packed(HierarchyStats& measured, const AnyHierarchy& hierarchy, const Mesh& mesh,
                const StatsOptions& options) {
    if (!can_pack(measured.kind)) return;
    for (const PackedLayout& layout : packed_layouts(options)) {
        PackedStats row;
        row.layout = packed_layout_name(layout);
        const auto start = Clock::now();
        try {
            row.bytes = bytes_of(pack_any(layout, hierarchy, mesh, measured.mesh, options.threads));
        } catch (const InputError& error) {
            row.refused = error.what();
        }
        row.ms = milliseconds_since(start);
        measured.packed.push_back(row);
    }
}

std::vector<HierarchyStats> measure(const StatsOptions& options, const Console& console) {
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    BuildOptions build = options.hierarchy.build();
    check_threads(options.threads);
    build.threads = options.threads;
    // Refuse wrong layouts before the work.
    packed_layouts(options);
    const scenes::Scene scene = options.scene.load();
    std::vector<HierarchyStats> result;
    Progress progress(console, scene.meshes.size() * kinds.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m].mesh;
        check_mesh(mesh, scene.meshes[m].name);
        auto start = Clock::now();
        const MeshTopology shared = mesh_topology(mesh, build.topology());
        const auto& [topology, points] = shared;
        const double topology_ms = milliseconds_since(start);
        const MeshFacts facts = mesh_facts(mesh);
        std::optional<MeasuredMesh> for_measures;
        if (options.measures) for_measures = measured_mesh(mesh, *topology, points, build.threads);
        for (const VolumeKind kind : kinds) {
            HierarchyStats measured;
            start = Clock::now();
            const AnyHierarchy hierarchy =
                fit_any(kind, topology, points, build.fit, build.threads);
            measured.fit_ms = milliseconds_since(start);
            measured.topology_ms = topology_ms;
            measured.mesh = scene.meshes[m].name;
            for (const scenes::Body& body : scene.bodies)
                if (body.mesh == m) measured.bodies.push_back(body.name);
            measured.triangles = mesh.triangles.size();
            measured.points = points.points.size();
            measured.nodes = topology->nodes.size();
            measured.bytes = bytes_of(hierarchy);
            measured.bytes_per_node = sizeof(TopologyNode) + bytes_per_volume(hierarchy);
            measured.kind = kind;
            measured.build = build;
            measured.facts = facts;
            measured.levels = level_statistics(hierarchy);
            if (options.measures)
                measured.measures = hierarchy_measures(hierarchy, *for_measures, build.threads);
            if (!options.csv) add_packed(measured, hierarchy, mesh, options);
            result.push_back(std::move(measured));
            progress.step("hierarchies");
        }
    }
    return result;
}

void print_stats(const StatsOptions& options, const std::vector<HierarchyStats>& all) {
    std::string text;
    if (options.json) {
        Json list = Json::array();
        for (const HierarchyStats& m : all) list.push_back(stats_json(m));
        text =
            Json{{"hierarchies", list}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    } else if (options.csv) {
        text = stats_csv_header(options.measures);
        for (const HierarchyStats& m : all) text += stats_csv(m);
    } else {
        for (const HierarchyStats& m : all) text += (text.empty() ? "" : "\n") + stats_table(m);
    }
    print_result(text);
}

/// Measures by level are of no use for deeper trees, which are lists.
constexpr std::size_t most_measured_levels = 2000;

/// The trees of a recording, each once, at its first frame.
std::vector<HierarchyStats> measure_recorded(const StatsOptions& options) {
    check_threads(options.threads);
    const scenes::Recording recording = scenes::read_recording(options.scene.recording_file());
    const scenes::RecordedBodies recorded = scenes::bodies_at(recording, options.scene.frames);
    std::vector<HierarchyStats> result;
    std::map<std::uint32_t, std::size_t> places;  // of trees, by number
    for (const BodyAtFrame& body : recorded.bodies) {
        const auto [place, added] = places.try_emplace(body.number, result.size());
        if (!added) {
            result[place->second].bodies.push_back(body.name);
            continue;
        }
        HierarchyStats& measured = result.emplace_back();
        measured.mesh = body.name;
        measured.bodies = {body.name};
        measured.engine = recording.engine;
        measured.volumes = recorded.volumes;
        measured.nodes = body.tree->size();
        measured.levels = level_statistics(*body.tree);
        measured.triangles = body.mesh->triangles.size();
        if (measured.triangles == 0) {
            measured.objects = render::item_count(*body.mesh, *body.tree).count;
            continue;
        }
        const std::vector<std::uint32_t> welded = joined_vertices(*body.mesh);
        for (std::uint32_t i = 0; i < welded.size(); ++i) measured.points += welded[i] == i;
        measured.facts = mesh_facts(*body.mesh);
        if (measured.levels.size() > most_measured_levels && options.measures)
            throw InputError(options.scene.names[0] + ": the tree of " + body.name + " is " +
                             std::to_string(measured.levels.size() - 1) +
                             " levels deep, and --measures takes " +
                             std::to_string(most_measured_levels - 1) + "; leave it out.");
        if (options.measures)
            measured.measures = tree_measures(*body.tree, *body.mesh, options.threads);
    }
    return result;
}

int run(const StatsOptions& options, const Console& console) {
    check_one_format(options.json, options.csv);
    const bool recorded = options.scene.is_recording() && asks_for_recorded(options.recording);
    if (recorded) {
        print_stats(options, measure_recorded(options));
        return exit_done;
    }
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    note_doubts(options.hierarchy, kinds, console.notes());
    const StatsOptions defaults;
    const bool packs = std::any_of(kinds.begin(), kinds.end(), can_pack);
    if (options.csv || !packs)
        for (const auto& [option, given] :
             {std::pair("--layout", options.layouts != defaults.layouts),
              std::pair("--leaf", options.leaf_triangles != defaults.leaf_triangles)})
            if (given)
                console.note("scb: " + std::string(option) + " has no effect: " +
                             (packs ? "CSV has the levels alone."
                                    : "only slab cut balls have packed layouts."));
    print_stats(options, measure(options, console));
    return exit_done;
}

}  // namespace

void add_stats(const Command& program, const Console& console, Action& action) {
    const Command command =
        program.add_subcommand("stats", "Print the quality of hierarchies, level by level");
    const auto options = std::make_shared<StatsOptions>();
    add_scene_options(command, options->scene, false);
    add_hierarchy_options(command, options->hierarchy);
    command.add_option("--layout", options->layouts, "Packed layouts of slab cut balls to report")
        .offer_list(layout_words())
        .type_name("LIST")
        .show_default();
    add_leaf_option(command, options->leaf_triangles);
    add_threads_option(command, options->threads, "Threads that build; the result is the same");
    command.add_flag("--measures", options->measures,
                     "Also SAH cost, EPO, LCV, overlap of siblings, and tightness against convex "
                     "hulls; takes longer");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.add_flag("--csv", options->csv,
                     "Print CSV: a line per level, and a line for all levels");
    command.footer(
        "box: of the mesh, in its own frame and units. closed: each edge has two triangles; "
        "corners "
        "with equal coordinates are one\n"
        "vertex, whatever their indices; components have none in common. slenderness: the longest "
        "side of a triangle over the height\n"
        "on it, 1.15 where all sides are equal; volumes of long and slender triangles are loose.\n"
        "nodes: at that depth; leaves: how many of them are leaves; cover: these nodes and the "
        "leaves above, as in a picture of\n"
        "the level; d is the diameter 2r, tau the thickness e - f (of an OBB: diagonal and "
        "shortest side), in the mesh's units;\n"
        "ratio: mean over the mean of the level above. On a smooth surface d halves every other "
        "level and tau quarters\n"
        "(Section 3.1 of the paper).\n"
        "split by: how many nodes each rule divided. The rules: through the middle of the longest, "
        "second or third side of the\n"
        "node's box; at the median of 7 random centroids; sorted along the longest side and halved "
        "(fewer than 8 triangles);\n"
        "by index (all centroids coincide); at the least cost (--split cost).\n\n"
        "--measures: SAH cost: summed area, inner nodes 1.2 times, over the root's area; EPO: the "
        "area of the mesh inside volumes of\n"
        "nodes to which it does not belong, weighted alike, over the area of the mesh; tight: "
        "volume of the convex hull of the points\n"
        "over that of the bounding volume, and overlap: volume that two siblings share over that "
        "of the smaller one, both means over\n"
        "solid nodes, whose points lie in no plane; hulls, shared: these volumes summed over all "
        "nodes (Aila, Karras and Laine 2013).\n\n"
        "Examples:\n  scb stats spheres-l1 --volume scb,ball\n"
        "  scb stats knots-l1 --volume scb,obb --measures");
    command.callback([&action, &console, command, options] {
        options->recording = given_hierarchy_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
