#pragma once

#include <filesystem>
#include <string>

#include "core/platform/json_reader.h"
#include "scenes/scene/scene_file.h"

namespace scb::scenes {

/// The file that a field of a scene file names: beside the scene file, or else in the folder of
/// models. Throws InputError, naming file and place, if there is none; `kind` is "mesh file",
/// `remark` follows the name.
std::filesystem::path named_file(const JsonPlace& place, const SceneContext& context,
                                 const std::string& kind, const std::string& remark = "");

}  // namespace scb::scenes
