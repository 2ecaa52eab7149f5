#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/view/view_columns.h"
#include "render/figures/level_figure.h"
#include "render/view/camera.h"
#include "render/web/block_store.h"

namespace scb::app {

/// What the page of `scb view` begins with.
struct ViewStart {
    int level = 0;
    render::LevelStyle style;
    bool has_theme = true;  ///< whether the style's was asked for; else the reader's is taken
    render::Camera camera;
    double aspect = 1;           ///< width over height of the view that it is fitted to
    Vec3 center = Vec3::Zero();  ///< of the scene
    Vec3 up = Vec3::UnitZ();
    /// By kind of picture, "levels" and so on: the commands that draw it, but for what is chosen in
    /// the page; of two scenes there are two.
    std::map<std::string, std::vector<std::string>> commands;
};

/// Red, green, blue.
nlohmann::ordered_json color_json(render::Rgba8 color);

/// What the blocks of a page mean, and what it begins with: see render/web/main.js. Adds the
/// hierarchies, meshes and poses of all frames to the store.
nlohmann::ordered_json view_manifest(const ViewSubject& subject, const ViewStart& start,
                                     render::BlockStore& store);

}  // namespace scb::app
