#pragma once

#include <string>
#include <vector>

#include "app/study/scene_setup.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {

/// Trees of one kind, one per body.
struct LevelTrees {
    std::string title, name;  ///< for readers, and for file names
    std::vector<BodyAtFrame> bodies;
};

/// Bodies at a frame with trees of one or several kinds, built here or recorded, and the levels to
/// show.
struct LevelSubject {
    scenes::Scene scene;
    int frame = 0;
    int deepest = 0;
    std::vector<int> levels;
    std::vector<LevelTrees> trees;
    std::vector<std::vector<AnyHierarchy>>
        hierarchies;  ///< that `trees` refer to; per kind and mesh
    bool recorded = false;
};

/// The trees of a scene; or the recorded trees of a recording, if asks_for_recorded(given). Volumes
/// of nodes below the chosen levels (parse_levels) are not valid. Throws InputError.
LevelSubject level_subject(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                           const std::string& levels, const std::vector<std::string>& given,
                           const Note& note);

}  // namespace scb::app
