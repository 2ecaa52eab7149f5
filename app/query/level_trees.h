#pragma once

#include <string>
#include <vector>

#include "app/query/scene_options.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {

/// Trees of one kind, one per body.
struct LevelTrees {
    std::string title, name;  ///< for readers, and for files
    std::vector<scenes::BodyAtFrame> bodies;
};

/// Bodies at a frame with trees of one or several kinds, and the levels of these that are wanted:
/// built here, or recorded.
struct LevelSubject {
    scenes::Scene scene;
    int frame = 0;
    int deepest = 0;
    std::vector<int> levels;
    std::vector<LevelTrees> trees;
    std::vector<std::vector<AnyHierarchy>> hierarchies;  ///< that trees are of, per kind and mesh
    bool recorded = false;
};

/// Of a scene; of a recording its own trees, where `given` says so, see asks_for_recorded. Nodes
/// below the levels, see parse_levels, have no volumes that mean anything. Throws InputError.
LevelSubject level_subject(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                           const std::string& levels, const std::vector<std::string>& given,
                           const Console& console);

}  // namespace scb::app
