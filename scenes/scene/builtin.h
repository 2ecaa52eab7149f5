#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene/scene.h"

namespace scb::scenes {

/// A scene file that the program carries in itself.
struct BuiltinScene {
    std::string name;
    std::string description;
    std::string_view json;  ///< the scene file, see parse_scene
    int frames = 1;
    std::vector<std::string> mesh_files;  ///< that its models need, see load_builtin
};

/// All of them: the benchmark scenes of Section 5 of the paper first, then those of CAD models,
/// then the ones that show a strength or a weakness of slab cut balls. The order is fixed.
const std::vector<BuiltinScene>& builtin_scenes();

/// The built-in scene of this name, or null.
const BuiltinScene* find_builtin(std::string_view name);

/// The first mesh file that the scene needs and the folder lacks; empty where it has them all.
std::string missing_mesh_file(const BuiltinScene& scene, const std::filesystem::path& models_dir);

/// Makes the scene's meshes, or loads them from the folder of models. Throws InputError where that
/// lacks one of `mesh_files` or holds another mesh under its name, see parse_scene.
Scene load_builtin(const BuiltinScene& scene, const std::filesystem::path& models_dir = {});

}  // namespace scb::scenes
