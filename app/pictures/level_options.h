#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/pictures/picture_options.h"
#include "app/query/scene_options.h"
#include "render/figures/volume_colors.h"

namespace scb::app {

/// What `scb render levels` understands.
struct LevelOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    PictureOptions picture;
    CameraOptions camera;
    std::string levels = "auto";
    std::optional<render::ColorBy> color_by;  ///< none: auto
    std::optional<double> opacity;
    bool mesh = false, edges = false, no_sheet = false;
    /// What was given of what a recording already knows, see given_recording_options.
    std::vector<std::string> recording{};

    /// Refuses what makes no sense before any work is done; throws InputError.
    void check() const;

    /// What colors tell: as asked for, or else the body where there are several and the thickness
    /// where there is one.
    render::ColorBy resolved_color_by(std::size_t bodies) const;
    /// As asked for, or else such that a mesh that was asked for shows through.
    double resolved_opacity() const;
};

void add_level_options(const Command& command, LevelOptions& options);
/// Of these colors, opacity and meshes alone.
void add_level_look(const Command& command, LevelOptions& options);

}  // namespace scb::app
