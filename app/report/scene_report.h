#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/analysis/trace.h"
#include "scenes/scene/scene.h"

namespace scb::app {

/// The scene's title, as printable UTF-8, without repeated names: "cheese with itself" for
/// "cheese-cheese", which is one mesh twice, with the bodies "cheese-A" and "cheese-B"; else the
/// scene's name.
std::string scene_title(const std::string& scene, const std::string& a, const std::string& b);
/// The title of a query; for a self query it ends with "against itself".
std::string scene_title(const TraceHeader& header);
/// "left and right", or "left against itself".
std::string bodies_text(const TraceHeader& header);

/// A pose as twelve numbers: the matrix [R|t], row by row, as --pose reads it.
nlohmann::ordered_json pose_json(const Pose& pose);

/// The pose of every body in the world, at the first and the last of these frames; the scene
/// determines the poses between. {"0": {"A": [12 numbers], "B": [...]}, "490": {...}}
nlohmann::ordered_json poses_json(const scenes::Scene& scene, const std::vector<int>& frames);

/// The same for each of these frames.
nlohmann::ordered_json all_poses_json(const scenes::Scene& scene, const std::vector<int>& frames);

}  // namespace scb::app
