#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/pictures/level_options.h"
#include "render/figures/level_figure.h"

namespace scb::app {

/// The entry of a picture of a level in index.json: the counts shown; and, with `ids`,
/// numbers_by_id.
nlohmann::ordered_json level_entry(const std::string& volumes, int level, int frame,
                                   const std::vector<render::LevelBody>& bodies, bool ids);

/// The description of a run of `scb render levels` in index.json: the options and the camera.
/// `volumes`: the names of the volumes drawn.
nlohmann::ordered_json level_head(const LevelOptions& options, const scenes::Scene& scene,
                                  const std::vector<std::string>& volumes, int frame,
                                  const std::vector<int>& levels, const scenes::CameraView& camera);

}  // namespace scb::app
