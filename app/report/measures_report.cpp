#include "app/report/measures_report.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/statistics.h"
#include "core/base/text_format.h"

namespace scb::app {
namespace {

constexpr std::array level_fields = {
    LevelMeasure{"sah_cost", [](const LevelMeasures& m) { return m.sah_cost; }},
    LevelMeasure{"epo", [](const LevelMeasures& m) { return m.epo; }},
    LevelMeasure{"sibling_overlap", [](const LevelMeasures& m) { return m.sibling_overlap; }},
    LevelMeasure{"sibling_overlap_error",
                 [](const LevelMeasures& m) { return m.sibling_overlap_error; }},
    LevelMeasure{"overlap_volume", [](const LevelMeasures& m) { return m.overlap_volume; }},
    LevelMeasure{"tightness", [](const LevelMeasures& m) { return m.tightness; }},
    LevelMeasure{"hull_volume", [](const LevelMeasures& m) { return m.hull_volume; }},
    LevelMeasure{"solid_nodes", [](const LevelMeasures& m) { return double(m.solid); }},
};

constexpr std::array whole_fields = {
    WholeMeasure{"epo_error", &HierarchyMeasures::epo_error},
    WholeMeasure{"leaf_count", &HierarchyMeasures::leaf_count},
    WholeMeasure{"lcv", &HierarchyMeasures::lcv},
    WholeMeasure{"lcv_error", &HierarchyMeasures::lcv_error},
    WholeMeasure{"surface", &HierarchyMeasures::surface},
};

std::string share_cell(double share, std::uint32_t of) {
    return of == 0 ? std::string("        -") : format(" %6.2f %%", 100 * share);
}

std::string measures_row(const LevelMeasures& m) {
    return format(" %8u %7u %9.4g %9.4g", m.nodes, m.solid, m.sah_cost, m.epo) +
           share_cell(m.tightness, m.solid) + share_cell(m.sibling_overlap, m.solid_siblings) +
           format(" %9.4g %9.4g %9.4g %9.4g\n", m.area, m.volume, m.hull_volume, m.overlap_volume);
}

}  // namespace

std::span<const LevelMeasure> level_measures() { return level_fields; }
std::span<const WholeMeasure> whole_measures() { return whole_fields; }

nlohmann::ordered_json measures_json(const HierarchyMeasures& measures) {
    nlohmann::ordered_json result = {{"area", measures.all.area}, {"volume", measures.all.volume}};
    for (const LevelMeasure& field : level_fields) result[field.name] = field.of(measures.all);
    for (const WholeMeasure& field : whole_fields) result[field.name] = measures.*field.value;
    return result;
}

std::string measures_table(const HierarchyMeasures& m) {
    std::string text =
        "level    nodes   solid  SAH cost       EPO    tight  overlap      area    volume"
        "     hulls    shared\n";
    for (std::size_t i = 0; i < m.levels.size(); ++i)
        text += format("%5zu", i) + measures_row(m.levels[i]);
    return text + "  all" + measures_row(m.all) +
           format(
               "EPO %.4g +- %.1g; a line through the surface meets %.4g leaves;\n"
               "LCV, the standard deviation of that: %.4g +- %.1g\n",
               m.all.epo, m.epo_error, m.leaf_count, m.lcv, m.lcv_error) +
           "solid: nodes whose points lie in no plane; tight: the volume of the hull of these "
           "points\n"
           "over that of the node, their mean; overlap: the volume that two siblings share over "
           "that\n"
           "of the smaller, the mean; hulls, shared: sums of these volumes\n";
}

}  // namespace scb::app
