#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/level_options.h"
#include "render/context.h"
#include "render/level_figure.h"

namespace scb {

/// What index.json says of a run of `scb render levels`: the pictures with their counts, the
/// options, the camera, the versions.
struct LevelIndex {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();

    /// A picture of a level, with the counts that it shows.
    void add_level(const std::string& file, const std::string& ids_file, VolumeKind kind, int level,
                   int frame, const std::vector<LevelBody>& bodies);
    void add_sheet(const std::string& file);

    std::string text(const LevelOptions& options, const Scene& scene, int frame,
                     const std::vector<int>& levels, const CameraSpec& camera,
                     const GlInfo& gl) const;
};

}  // namespace scb
