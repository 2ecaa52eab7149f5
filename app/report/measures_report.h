#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/analysis/hierarchy_measures.h"

namespace scb::app {

/// A measure of a level and of a whole hierarchy, by its name in JSON and CSV.
struct LevelMeasure {
    const char* name;
    double (*of)(const LevelMeasures&);
};

/// The measures that LevelStatistics does not have.
std::span<const LevelMeasure> level_measures();

/// A measure of a whole hierarchy only.
struct WholeMeasure {
    const char* name;
    double HierarchyMeasures::*value;
};
std::span<const WholeMeasure> whole_measures();

/// The measures of the whole hierarchy.
nlohmann::ordered_json measures_json(const HierarchyMeasures& measures);
/// A row per level, and one for all levels.
std::string measures_table(const HierarchyMeasures& measures);

}  // namespace scb::app
