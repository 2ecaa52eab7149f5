#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/hierarchy_measures.h"
#include "core/geometry/mesh_facts.h"
#include "core/model/level_statistics.h"

namespace scb::app {

/// A packed layout of a hierarchy.
struct PackedStats {
    std::string layout;
    std::size_t bytes = 0;
    double ms = 0;
    std::string refused;  ///< why the layout is impossible; empty if it is possible
};

/// A hierarchy of a mesh, with the numbers of `scb stats`.
struct HierarchyStats {
    std::string mesh;
    std::vector<std::string> bodies;
    std::size_t triangles = 0, points = 0;
    std::size_t objects = 0;  ///< in a tree without triangles
    std::size_t nodes = 0, bytes = 0, bytes_per_node = 0;
    VolumeKind kind = VolumeKind::scb;
    BuildOptions build;
    MeshFacts facts;
    std::vector<LevelStatistics> levels;
    double topology_ms = 0, fit_ms = 0;
    std::vector<PackedStats> packed;            ///< of slab cut balls
    std::optional<HierarchyMeasures> measures;  ///< if asked for
    /// Only of another engine's tree: its engine and its volumes. It has no kind, build, memory,
    /// time or packed layouts.
    std::string engine, volumes;

    double per_triangle(std::size_t amount) const {
        return static_cast<double>(amount) / static_cast<double>(triangles);
    }
};

std::string stats_table(const HierarchyStats& stats);
nlohmann::ordered_json stats_json(const HierarchyStats& stats);

/// A line per level, root first, then one for all levels, whose level is "all". The header is one
/// line. `with_measures`: whether there are columns of measures.
std::string stats_csv_header(bool with_measures);
std::string stats_csv(const HierarchyStats& stats);

}  // namespace scb::app
