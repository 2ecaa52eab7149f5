#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "app/study/scene_setup.h"
#include "render/figures/volume_colors.h"

namespace scb::app {

class Command;

/// Options of `scb render levels`.
struct LevelOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    PictureOptions picture{.takes_file = true};
    CameraOptions camera;
    std::string levels = "auto";
    std::optional<render::ColorBy> color_by;  ///< none: auto
    std::optional<double> opacity;
    bool mesh = false, edges = false, no_sheet = false;
    /// The given options that a recording already has, see given_hierarchy_options.
    std::vector<std::string> recording{};

    /// Refuses invalid options before any work is done; throws InputError.
    void check() const;

    /// `color_by`; by default the body if there are several bodies, else the thickness.
    render::ColorBy resolved_color_by(std::size_t bodies) const;
    /// `opacity`; by default low enough that a drawn mesh shows through.
    double resolved_opacity() const;
};

void add_level_options(const Command& command, LevelOptions& options);
/// Only the options of colors, opacity and meshes.
void add_level_look(const Command& command, LevelOptions& options);

}  // namespace scb::app
