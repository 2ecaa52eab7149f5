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

/// The initial state of the page of `scb view`.
struct ViewStart {
    int level = 0;
    render::LevelStyle style;
    render::Camera camera;
    double aspect = 1;           ///< of the view that the camera is fitted to: width / height
    Vec3 center = Vec3::Zero();  ///< of the scene
    Vec3 up = Vec3::UnitZ();
    /// By kind of picture, such as "levels": the commands that draw it, without the choices in the
    /// page. For two scenes there are two.
    std::map<std::string, std::vector<std::string>> commands;
};

/// Red, green, blue.
nlohmann::ordered_json color_json(render::Rgba8 color);

/// The layout of the page's blocks, and its initial state: see render/web/main.js. Adds the
/// hierarchies, meshes and poses of all frames to the store.
nlohmann::ordered_json view_manifest(const ViewSubject& subject, const ViewStart& start,
                                     render::BlockStore& store);

}  // namespace scb::app
