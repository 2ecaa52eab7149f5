#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/pictures/level_options.h"
#include "render/figures/level_figure.h"

namespace scb::app {

/// What index.json says of a picture of a level: the counts that it shows; and, of one with `ids`,
/// what numbers_by_id says.
nlohmann::ordered_json level_entry(const std::string& volumes, int level, int frame,
                                   const std::vector<render::LevelBody>& bodies, bool ids);

/// What it says of a run of `scb render levels`: the options and the camera.
/// `volumes` are the names of what is drawn.
nlohmann::ordered_json level_head(const LevelOptions& options, const scenes::Scene& scene,
                                  const std::vector<std::string>& volumes, int frame,
                                  const std::vector<int>& levels, const scenes::CameraView& camera);

}  // namespace scb::app
