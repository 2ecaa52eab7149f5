#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"

namespace scb {

/// A scene file that the program carries in itself.
struct BuiltinScene {
    std::string name;
    std::string description;
    std::string_view json;  ///< the scene file, see parse_scene
    int frames = 1;
};

/// All of them: the benchmark scenes of Section 5 of the paper first, then the ones that show a
/// strength or a weakness of slab cut balls. The order is fixed.
const std::vector<BuiltinScene>& builtin_scenes();

/// The built-in scene of this name, or null.
const BuiltinScene* find_builtin(std::string_view name);

/// Makes the scene's meshes.
Scene load_builtin(const BuiltinScene& scene);

}  // namespace scb
