#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene/scene.h"

namespace scb::scenes {

/// A scene file embedded in the program.
struct BuiltinScene {
    std::string name;
    std::string description;
    std::string_view json;  ///< the scene file, see parse_scene
    int frames = 1;
    std::vector<std::string> mesh_files;  ///< files that its models need, see load_builtin
};

/// All built-in scenes: first the benchmark scenes of Section 5 of the paper, then scenes of CAD
/// models, then scenes that show a strength or a weakness of slab cut balls. The order is fixed.
const std::vector<BuiltinScene>& builtin_scenes();

/// The built-in scene of this name, or null.
const BuiltinScene* find_builtin(std::string_view name);

/// The first mesh file that the scene needs and the folder lacks; empty if the folder has all.
std::string missing_mesh_file(const BuiltinScene& scene, const std::filesystem::path& models_dir);

/// Makes the scene's meshes, or loads them from the folder of models. Throws InputError if the
/// folder lacks one of `mesh_files` or has another mesh under its name, see parse_scene.
Scene load_builtin(const BuiltinScene& scene, const std::filesystem::path& models_dir = {});

}  // namespace scb::scenes
