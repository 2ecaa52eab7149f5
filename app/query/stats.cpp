#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/build_text.h"
#include "app/cli/commands.h"
#include "app/query/layout_options.h"
#include "app/query/scene_options.h"
#include "core/base/exit_status.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_facts.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/level_statistics.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/any_packed.h"
#include "scb/error.h"

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
    bool json = false;
};

/// A packed layout of a hierarchy.
struct Packed {
    std::string layout;
    std::size_t bytes = 0;
    double ms = 0;
    std::string refused;  ///< why it cannot be; empty where it could
};

/// Those of --layout.
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

struct Measured {
    std::string mesh;
    std::vector<std::string> bodies;
    std::size_t triangles = 0, points = 0, nodes = 0, bytes = 0, bytes_per_node = 0;
    VolumeKind kind = VolumeKind::scb;
    BuildOptions build;
    MeshFacts facts;
    std::vector<LevelStatistics> levels;
    double topology_ms = 0, fit_ms = 0;
    std::vector<Packed> packed;  ///< of slab cut balls

    double per_triangle(std::size_t amount) const {
        return static_cast<double>(amount) / static_cast<double>(triangles);
    }
};

void add_packed(Measured& measured, const AnyHierarchy& hierarchy, const Mesh& mesh,
                const StatsOptions& options) {
    if (!can_pack(measured.kind)) return;
    for (const PackedLayout& layout : packed_layouts(options)) {
        Packed row;
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

std::vector<Measured> measure(const StatsOptions& options) {
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    BuildOptions build = options.hierarchy.build();
    check_threads(options.threads);
    build.threads = options.threads;
    // Before anything is built.
    packed_layouts(options);
    const scenes::Scene scene = options.scene.load();
    std::vector<Measured> result;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m].mesh;
        check_mesh(mesh, scene.meshes[m].name);
        auto start = Clock::now();
        const MeshTopology shared = mesh_topology(mesh, build.topology());
        const auto& [topology, points] = shared;
        const double topology_ms = milliseconds_since(start);
        const MeshFacts facts = mesh_facts(mesh);
        for (const VolumeKind kind : kinds) {
            Measured measured;
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
            add_packed(measured, hierarchy, mesh, options);
            result.push_back(std::move(measured));
        }
    }
    return result;
}

std::string rules_text(const LevelStatistics& level) {
    std::string text;
    for (std::size_t r = 1; r < split_rule_count; ++r)
        if (level.rules[r] != 0)
            text += format("%s%s %u", text.empty() ? "" : ", ",
                           std::string(split_rule_name(static_cast<SplitRule>(r))).c_str(),
                           level.rules[r]);
    return text;
}

std::string vector_text(const Vec3& v) { return format("%.6g, %.6g, %.6g", v[0], v[1], v[2]); }

std::string share_text(std::size_t part, std::size_t whole) {
    return format("%.1f %%", 100 * ratio(static_cast<double>(part), static_cast<double>(whole)));
}

std::string slenderness_text(const MeshFacts& f) {
    const std::size_t measured = f.triangles - f.degenerate;
    if (measured == 0) return "all triangles are degenerate";
    std::string text = format("median %.3g;", f.median_slenderness);
    for (std::size_t c = 0, limit = 1; c < slenderness_classes; ++c, limit *= 4) {
        const std::string range = c == 0 ? "below 4"
                                  : c + 1 == slenderness_classes
                                      ? format("%zu and more", limit)
                                      : format("%zu to %zu", limit, 4 * limit);
        text += (c == 0 ? " " : ", ") + range + ": " + share_text(f.slenderness[c], measured);
    }
    return text;
}

std::string facts_text(const MeshFacts& f) {
    std::string text = "box          " + vector_text(f.box.lower) + " to " +
                       vector_text(f.box.upper) + "; size " +
                       vector_text(f.box.upper - f.box.lower) + "\n" + "surface      " +
                       (f.closed() ? "closed"
                                   : format("open: %zu edges of one triangle, %zu of more than two",
                                            f.open_edges, f.crowded_edges)) +
                       format("; %zu component%s\n", f.components, f.components == 1 ? "" : "s") +
                       format("triangles    %zu degenerate, %zu duplicates of others\n",
                              f.degenerate, f.duplicates) +
                       "slenderness  " + slenderness_text(f) + "\n";
    if (f.slender() > 0)
        text += format("             the longest of 16 and more is triangle %u, %.6g long\n",
                       f.longest_slender, f.longest_slender_side);
    return text;
}

std::string table(const Measured& m) {
    std::string bodies;
    for (const std::string& body : m.bodies) bodies += (bodies.empty() ? "" : ", ") + body;
    std::string text = m.mesh + (m.bodies.size() == 1 ? " (body " : " (bodies ") + bodies +
                       format("): %zu triangles, %zu distinct points, ", m.triangles, m.points) +
                       std::string(volume_kind_name(m.kind)) + " hierarchy" + build_text(m.build) +
                       "\n" + facts_text(m.facts) + "\n" +
                       "level    nodes   leaves    cover    mean d     max d d ratio  mean tau   "
                       "max tau tau ratio  "
                       "     area     volume  split by\n";
    for (std::size_t i = 0; i < m.levels.size(); ++i) {
        const LevelStatistics& l = m.levels[i];
        const LevelStatistics& above = m.levels[i == 0 ? 0 : i - 1];
        const auto ratio_text = [i](double value, double before) {
            return i == 0 ? std::string("        ") : format(" %7.3f", ratio(value, before));
        };
        text += format("%5zu %8u %8u %8u %9.4g %9.4g", i, l.volumes, l.leaves, l.cover,
                       l.mean_diameter(), l.max_diameter) +
                ratio_text(l.mean_diameter(), above.mean_diameter()) +
                format(" %9.4g %9.4g", l.mean_thickness(), l.max_thickness) +
                ratio_text(l.mean_thickness(), above.mean_thickness()) +
                format("   %10.4g %10.4g  ", l.area, l.volume) + rules_text(l) + "\n";
    }
    LevelStatistics total;
    for (const LevelStatistics& l : m.levels)
        for (std::size_t r = 0; r < split_rule_count; ++r) total.rules[r] += l.rules[r];
    text += format("\ndepth %zu, %zu nodes, %zu bytes per node (%.1f per triangle), split by: ",
                   m.levels.size() - 1, m.nodes, m.bytes_per_node, m.per_triangle(m.bytes)) +
            rules_text(total) +
            format("\ntime here (differs from run to run): topology %.1f ms, fit %.1f ms\n",
                   m.topology_ms, m.fit_ms);
    if (!m.packed.empty()) text += "\npacked layout  bytes per triangle  time here, ms\n";
    for (const Packed& packed : m.packed)
        text += packed.refused.empty()
                    ? format("%-13s %19.1f %14.1f\n", packed.layout.c_str(),
                             m.per_triangle(packed.bytes), packed.ms)
                    : format("%-13s %19s  ", packed.layout.c_str(), "-") + packed.refused + "\n";
    return text;
}

Json vector_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json facts_json(const MeshFacts& f) {
    return {{"box", {{"lower", vector_json(f.box.lower)}, {"upper", vector_json(f.box.upper)}}},
            {"components", f.components},
            {"closed", f.closed()},
            {"open_edges", f.open_edges},
            {"crowded_edges", f.crowded_edges},
            {"degenerate", f.degenerate},
            {"duplicates", f.duplicates},
            {"slenderness", f.slenderness},
            {"median_slenderness", f.median_slenderness},
            {"slender", f.slender()},
            {"longest_slender_side", f.longest_slender_side}};
}

Json json_of(const Measured& m) {
    Json levels = Json::array();
    for (std::size_t i = 0; i < m.levels.size(); ++i) {
        const LevelStatistics& l = m.levels[i];
        Json level = {{"level", i},
                      {"nodes", l.volumes},
                      {"leaves", l.leaves},
                      {"cover", l.cover},
                      {"mean_diameter", l.mean_diameter()},
                      {"max_diameter", l.max_diameter},
                      {"mean_thickness", l.mean_thickness()},
                      {"max_thickness", l.max_thickness},
                      {"area", l.area},
                      {"volume", l.volume}};
        if (i > 0) {
            level["diameter_ratio"] = ratio(l.mean_diameter(), m.levels[i - 1].mean_diameter());
            level["thickness_ratio"] = ratio(l.mean_thickness(), m.levels[i - 1].mean_thickness());
        }
        for (std::size_t r = 0; r < split_rule_count; ++r)
            level["rules"][std::string(split_rule_name(static_cast<SplitRule>(r)))] = l.rules[r];
        levels.push_back(std::move(level));
    }
    Json packed = Json::array();
    for (const Packed& p : m.packed) {
        if (p.refused.empty())
            packed.push_back({{"layout", p.layout},
                              {"bytes", p.bytes},
                              {"bytes_per_triangle", m.per_triangle(p.bytes)},
                              {"ms", p.ms}});
        else
            packed.push_back({{"layout", p.layout}, {"refused", p.refused}});
    }
    Json result = {{"mesh", m.mesh},
                   {"bodies", m.bodies},
                   {"volume", volume_kind_name(m.kind)},
                   {"growth", ball_growth_name(m.build.fit.growth)},
                   {"margin", m.build.fit.margin},
                   {"split", split_method_name(m.build.split)},
                   {"triangles", m.triangles},
                   {"points", m.points},
                   {"facts", facts_json(m.facts)},
                   {"nodes", m.nodes},
                   {"depth", m.levels.size() - 1},
                   {"bytes_per_node", m.bytes_per_node},
                   {"bytes_per_triangle", m.per_triangle(m.bytes)},
                   {"levels", levels},
                   {"time", {{"topology_ms", m.topology_ms}, {"fit_ms", m.fit_ms}}}};
    if (can_pack(m.kind)) result["packed"] = std::move(packed);
    return result;
}

int run(const StatsOptions& options, const Console& console) {
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    note_doubts(options.hierarchy, kinds, console);
    const StatsOptions defaults;
    if (std::none_of(kinds.begin(), kinds.end(), can_pack))
        for (const auto& [option, given] :
             {std::pair("--layout", options.layouts != defaults.layouts),
              std::pair("--leaf", options.leaf_triangles != defaults.leaf_triangles)})
            if (given)
                console.note("scb: " + std::string(option) +
                             " has no effect: only slab cut balls have packed layouts.");
    const std::vector<Measured> all = measure(options);
    std::string text;
    if (options.json) {
        Json list = Json::array();
        for (const Measured& m : all) list.push_back(json_of(m));
        text =
            Json{{"hierarchies", list}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    } else {
        for (const Measured& m : all) text += (text.empty() ? "" : "\n") + table(m);
    }
    print_result(text);
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
        .type_name("LIST")
        .show_default();
    add_leaf_option(command, options->leaf_triangles);
    add_threads_option(command, options->threads, "Threads that build; the result is the same");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
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
        "Example:\n  scb stats spheres-l1 --volume scb,ball");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
