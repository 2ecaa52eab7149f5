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
    std::string refused;  ///< why it cannot be; empty where it could
};

/// A hierarchy of a mesh and what `scb stats` says of it.
struct HierarchyStats {
    std::string mesh;
    std::vector<std::string> bodies;
    std::size_t triangles = 0, points = 0;
    std::size_t objects = 0;  ///< of a tree without triangles
    std::size_t nodes = 0, bytes = 0, bytes_per_node = 0;
    VolumeKind kind = VolumeKind::scb;
    BuildOptions build;
    MeshFacts facts;
    std::vector<LevelStatistics> levels;
    double topology_ms = 0, fit_ms = 0;
    std::vector<PackedStats> packed;            ///< of slab cut balls
    std::optional<HierarchyMeasures> measures;  ///< where asked for
    /// Of another engine's tree its name and its volumes; then there is no kind, no build, no
    /// memory, no time and nothing packed.
    std::string engine, volumes;

    double per_triangle(std::size_t amount) const {
        return static_cast<double>(amount) / static_cast<double>(triangles);
    }
};

std::string stats_table(const HierarchyStats& stats);
nlohmann::ordered_json stats_json(const HierarchyStats& stats);

/// A line per level, root first, then one of all levels, whose level is "all"; the header is
/// without a line end's line. `with_measures`: whether they have them.
std::string stats_csv_header(bool with_measures);
std::string stats_csv(const HierarchyStats& stats);

}  // namespace scb::app
