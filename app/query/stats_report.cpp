#include "app/query/stats_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/build_text.h"
#include "app/query/count_table.h"
#include "app/query/measures_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "scb/any_packed.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

std::string rules_text(const LevelStatistics& level) {
    std::string text;
    for (std::size_t r = 1; r < split_rule_count; ++r)
        if (level.rules[r] != 0)
            text += format("%s%s %u", text.empty() ? "" : ", ",
                           std::string(split_rule_name(static_cast<SplitRule>(r))).c_str(),
                           level.rules[r]);
    return text;
}

/// A vector of a box with that diagonal; rounding errors become 0.
std::string vector_text(const Vec3& v, double diagonal) {
    const auto rounded = [&](double x) { return std::abs(x) <= 1e-12 * diagonal ? 0 : x; };
    return format("%.6g, %.6g, %.6g", rounded(v[0]), rounded(v[1]), rounded(v[2]));
}

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
    const Vec3 size = f.box.upper - f.box.lower;
    const auto vector = [diagonal = size.norm()](const Vec3& v) {
        return vector_text(v, diagonal);
    };
    std::string text = "box          " + vector(f.box.lower) + " to " + vector(f.box.upper) +
                       "; size " + vector(size) + "\n" + "surface      " +
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

}  // namespace

std::string stats_table(const HierarchyStats& m) {
    std::string bodies;
    for (const std::string& body : m.bodies) bodies += (bodies.empty() ? "" : ", ") + body;
    std::string text =
        m.mesh + (m.bodies.size() == 1 ? " (body " : " (bodies ") + bodies +
        (m.triangles > 0 ? format("): %zu triangles, %zu distinct points, ", m.triangles, m.points)
                         : format("): %zu objects, ", m.objects)) +
        (m.engine.empty()
             ? std::string(volume_kind_name(m.kind)) + " hierarchy" + build_text(m.build)
             : m.volumes + " tree of " + m.engine) +
        "\n" + (m.triangles > 0 ? facts_text(m.facts) : "") + "\n" +
        "level    nodes   leaves    cover    mean d     max d d ratio  mean tau   "
        "max tau tau ratio  "
        "     area     volume" +
        (m.engine.empty() ? "  split by" : "") + "\n";
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
                format("   %10.4g %10.4g", l.area, l.volume) +
                (m.engine.empty() ? "  " + rules_text(l) : "") + "\n";
    }
    if (!m.engine.empty())
        return text + format("\ndepth %zu, %zu nodes\n", m.levels.size() - 1, m.nodes) +
               (m.measures ? "\n" + measures_table(*m.measures) : "");
    LevelStatistics total;
    for (const LevelStatistics& l : m.levels)
        for (std::size_t r = 0; r < split_rule_count; ++r) total.rules[r] += l.rules[r];
    text += format("\ndepth %zu, %zu nodes, %zu bytes per node (%.1f per triangle), split by: ",
                   m.levels.size() - 1, m.nodes, m.bytes_per_node, m.per_triangle(m.bytes)) +
            rules_text(total) +
            format("\ntime here (differs from run to run): topology %.1f ms, fit %.1f ms\n",
                   m.topology_ms, m.fit_ms);
    if (m.measures) text += "\n" + measures_table(*m.measures);
    if (!m.packed.empty()) text += "\npacked layout  bytes per triangle  time here, ms\n";
    for (const PackedStats& packed : m.packed)
        text += packed.refused.empty()
                    ? format("%-13s %19.1f %14.1f\n", packed.layout.c_str(),
                             m.per_triangle(packed.bytes), packed.ms)
                    : format("%-13s %19s  ", packed.layout.c_str(), "-") + packed.refused + "\n";
    return text;
}

Json stats_json(const HierarchyStats& m) {
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
        if (m.measures)
            for (const LevelMeasure& field : level_measures())
                level[field.name] = field.of(m.measures->levels[i]);
        for (std::size_t r = 0; r < split_rule_count && m.engine.empty(); ++r)
            level["rules"][std::string(split_rule_name(static_cast<SplitRule>(r)))] = l.rules[r];
        levels.push_back(std::move(level));
    }
    Json packed = Json::array();
    for (const PackedStats& p : m.packed) {
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
    if (m.measures) result["measures"] = measures_json(*m.measures);
    if (!m.engine.empty()) {
        result["engine"] = m.engine;
        result["volume"] = m.volumes;
        if (m.objects > 0) result["objects"] = m.objects;
        for (const char* own :
             {"growth", "margin", "split", "bytes_per_node", "bytes_per_triangle", "time"})
            result.erase(own);
        return result;
    }
    if (can_pack(m.kind)) result["packed"] = std::move(packed);
    return result;
}

std::string stats_csv_header(bool with_measures) {
    std::string text =
        "mesh,bodies,hierarchy,split,level,nodes,leaves,cover,mean_diameter,max_diameter,mean_"
        "thickness,"
        "max_thickness,area,volume";
    if (with_measures) {
        for (const LevelMeasure& field : level_measures()) text += std::string(",") + field.name;
        for (const WholeMeasure& field : whole_measures()) text += std::string(",") + field.name;
    }
    return text + "\n";
}

std::string stats_csv(const HierarchyStats& m) {
    std::string bodies;
    for (const std::string& body : m.bodies) bodies += (bodies.empty() ? "" : " ") + body;
    const std::string start = csv_field(m.mesh) + "," + csv_field(bodies) + "," +
                              (m.engine.empty() ? std::string(volume_kind_name(m.kind)) + "," +
                                                      std::string(split_method_name(m.build.split))
                                                : csv_field(m.engine + ", " + m.volumes) + ",-") +
                              ",";
    const auto row = [](const VolumeStatistics& l) {
        return format("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", l.mean_diameter(), l.max_diameter,
                      l.mean_thickness(), l.max_thickness, l.area, l.volume);
    };
    const auto measures = [](const LevelMeasures& l) {
        std::string text;
        for (const LevelMeasure& field : level_measures()) text += format(",%.17g", field.of(l));
        return text;
    };
    std::string text;
    VolumeStatistics all;
    for (std::size_t i = 0; i < m.levels.size(); ++i) {
        const LevelStatistics& l = m.levels[i];
        all.add(l);
        text += start + format("%zu,%u,%u,%u,", i, l.volumes, l.leaves, l.cover) + row(l) +
                (m.measures
                     ? measures(m.measures->levels[i]) + std::string(whole_measures().size(), ',')
                     : std::string()) +
                "\n";
    }
    text += start + format("all,%u,%u,,", all.volumes, all.leaves) + row(all);
    if (m.measures) {
        text += measures(m.measures->all);
        for (const WholeMeasure& field : whole_measures())
            text += format(",%.17g", *m.measures.*field.value);
    }
    return text + "\n";
}

}  // namespace scb::app
