#include "app/report/stats_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/build_text.h"
#include "app/report/count_table.h"
#include "app/report/measures_report.h"
#include "app/report/table.h"
#include "app/report/wrapped_text.h"
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
    std::string text =
        "box          " + vector(f.box.lower) + " to " + vector(f.box.upper) + "\n" +
        "size         " + vector(size) + "\n" + "surface      " +
        (f.closed()
             ? "closed"
             : "not closed: " + counted(f.open_edges, "edge", "edges") + " of one triangle, " +
                   count_text(f.crowded_edges) + " of more than two") +
        "; " + counted(f.components, "component", "components") + "\n" + "triangles    " +
        count_text(f.degenerate) + " degenerate, " + count_text(f.duplicates) +
        " duplicates of others\n" + wrapped_text("slenderness  " + slenderness_text(f), 13) + "\n";
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

/// A level of a hierarchy, or all levels.
struct LevelRow {
    Cell level;
    VolumeStatistics l;
    Cell cover;
    const VolumeStatistics* above;   ///< the level above, for the ratios
    const LevelMeasures* measures;   ///< null if not asked for
    const HierarchyMeasures* whole;  ///< only of all levels
};

std::vector<Field<LevelRow>> level_columns(bool with_measures) {
    const auto shown = [](double value) { return Cell(value, "%.4g"); };
    const auto to_above = [](const LevelRow& r, double (VolumeStatistics::*of)() const) {
        return r.above ? Cell(ratio((r.l.*of)(), (r.above->*of)()), "%.2f") : Cell();
    };
    std::vector<Field<LevelRow>> fields = {
        {{"level", "level", 5}, [](auto& r) { return r.level; }},
        {{"nodes", "nodes", 8}, [](auto& r) { return r.l.volumes; }},
        {{"leaves", "leaves", 8}, [](auto& r) { return r.l.leaves; }},
        {{"cover", "cover", 8}, [](auto& r) { return r.cover; }},
        {{"mean d", "mean_diameter", 10}, [=](auto& r) { return shown(r.l.mean_diameter()); }},
        {{"max d", "max_diameter", 10}, [=](auto& r) { return shown(r.l.max_diameter); }},
        {{"ratio", "diameter_ratio", 6, Align::right, 0, false},
         [=](auto& r) { return to_above(r, &VolumeStatistics::mean_diameter); }},
        {{"mean tau", "mean_thickness", 10}, [=](auto& r) { return shown(r.l.mean_thickness()); }},
        {{"max tau", "max_thickness", 10}, [=](auto& r) { return shown(r.l.max_thickness); }},
        {{"ratio", "thickness_ratio", 6, Align::right, 0, false},
         [=](auto& r) { return to_above(r, &VolumeStatistics::mean_thickness); }},
        {{"area", "area", 9}, [](auto& r) { return Cell(r.l.area, "%.3g"); }},
        {{"volume", "volume", 9}, [](auto& r) { return Cell(r.l.volume, "%.3g"); }}};
    if (with_measures) {
        for (const LevelMeasure& field : level_measures())
            fields.push_back(
                {{"", field.name}, [=](auto& r) { return shown(field.of(*r.measures)); }});
        for (const WholeMeasure& field : whole_measures())
            fields.push_back({{"", field.name}, [=](auto& r) {
                                  return r.whole ? shown(*r.whole.*field.value) : Cell();
                              }});
    }
    return fields;
}

std::vector<LevelRow> level_rows(const HierarchyStats& m) {
    std::vector<LevelRow> rows;
    for (std::size_t i = 0; i < m.levels.size(); ++i) {
        const LevelStatistics& l = m.levels[i];
        rows.push_back({i, l, l.cover, i == 0 ? nullptr : &m.levels[i - 1],
                        m.measures ? &m.measures->levels[i] : nullptr, nullptr});
    }
    return rows;
}

Table level_table(const HierarchyStats& m) {
    return table_of(level_columns(m.measures.has_value()), level_rows(m));
}

Table packed_table(const HierarchyStats& m) {
    Table table({{"packed layout", "layout", 13, Align::left},
                 {"", "refused"},
                 {"", "bytes"},
                 {"bytes per triangle", "bytes_per_triangle", 20},
                 {"time here, ms", "ms", 15}});
    for (const PackedStats& p : m.packed)
        if (p.refused.empty())
            table.add({p.layout, {}, p.bytes, {m.per_triangle(p.bytes), "%.1f"}, {p.ms, "%.1f"}});
        else
            table.add({p.layout, p.refused, {}, {nullptr, "-"}},
                      "\n" + wrapped_text("    " + p.refused, 4));
    return table;
}

}  // namespace

std::string stats_table(const HierarchyStats& m) {
    std::string bodies;
    for (const std::string& body : m.bodies) bodies += (bodies.empty() ? "" : ", ") + body;
    const std::string title =
        m.mesh + (m.bodies.size() == 1 ? " (body " : " (bodies ") + bodies + "): " +
        (m.triangles > 0 ? counted(m.triangles, "triangle", "triangles") + ", " +
                               counted(m.points, "distinct point", "distinct points")
                         : counted(m.objects, "object", "objects")) +
        ", " +
        (m.engine.empty()
             ? std::string(volume_kind_name(m.kind)) + " hierarchy" + build_text(m.build)
             : m.volumes + " tree of " + m.engine);
    std::string text = wrapped_text(title, 4) + "\n" +
                       (m.triangles > 0 ? facts_text(m.facts) : "") + "\n" + level_table(m).text() +
                       format("\ndepth %zu, ", m.levels.size() - 1) +
                       counted(m.nodes, "node", "nodes");
    if (!m.engine.empty())
        return text + "\n" + (m.measures ? "\n" + measures_table(*m.measures) : "");
    LevelStatistics total;
    for (const LevelStatistics& l : m.levels)
        for (std::size_t r = 0; r < split_rule_count; ++r) total.rules[r] += l.rules[r];
    text += format(", %zu bytes per node (%.1f per triangle)\n", m.bytes_per_node,
                   m.per_triangle(m.bytes)) +
            wrapped_text("split by: " + rules_text(total), 10) +
            format("\ntime here (differs from run to run): topology %.1f ms, fit %.1f ms\n",
                   m.topology_ms, m.fit_ms);
    if (m.measures) text += "\n" + measures_table(*m.measures);
    if (!m.packed.empty()) text += "\n" + packed_table(m).text();
    return text;
}

Json stats_json(const HierarchyStats& m) {
    Json levels = level_table(m).json();
    for (std::size_t i = 0; i < m.levels.size() && m.engine.empty(); ++i)
        for (std::size_t r = 0; r < split_rule_count; ++r)
            levels[i]["rules"][std::string(split_rule_name(static_cast<SplitRule>(r)))] =
                m.levels[i].rules[r];
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
    if (can_pack(m.kind)) result["packed"] = packed_table(m).json();
    return result;
}

std::string stats_csv_header(bool with_measures) {
    return "mesh,bodies,hierarchy,split," + table_of(level_columns(with_measures)).csv_header();
}

std::string stats_csv(const HierarchyStats& m) {
    std::string bodies;
    for (const std::string& body : m.bodies) bodies += (bodies.empty() ? "" : " ") + body;
    VolumeStatistics all;
    for (const LevelStatistics& l : m.levels) all.add(l);
    std::vector<LevelRow> rows = level_rows(m);
    rows.push_back({"all",
                    all,
                    {},
                    nullptr,
                    m.measures ? &m.measures->all : nullptr,
                    m.measures ? &*m.measures : nullptr});
    return table_of(level_columns(m.measures.has_value()), rows)
        .csv_rows(csv_field(m.mesh) + "," + csv_field(bodies) + "," +
                  (m.engine.empty() ? std::string(volume_kind_name(m.kind)) + "," +
                                          std::string(split_method_name(m.build.split))
                                    : csv_field(m.engine + ", " + m.volumes) + ",-") +
                  ",");
}

}  // namespace scb::app
