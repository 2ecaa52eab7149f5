#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "scenes/scene/scene.h"

namespace scb::app {

/// A pose as twelve numbers: the matrix [R|t], row by row, as --pose reads it.
nlohmann::ordered_json pose_json(const Pose& pose);

/// The pose of every body in the world, at the first and the last of these frames; the scene
/// determines the poses between. {"0": {"A": [12 numbers], "B": [...]}, "490": {...}}
nlohmann::ordered_json poses_json(const scenes::Scene& scene, const std::vector<int>& frames);

/// The same for each of these frames.
nlohmann::ordered_json all_poses_json(const scenes::Scene& scene, const std::vector<int>& frames);

}  // namespace scb::app
