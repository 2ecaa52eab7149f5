#pragma once

#include "core/platform/json_reader.h"
#include "scenes/scene/scene_file.h"

namespace scb::scenes {

/// Makes or loads the model at `place` of a scene file (see parse_scene). Throws InputError, naming
/// file and place.
NamedMesh read_model(const JsonPlace& place, const SceneContext& context);

}  // namespace scb::scenes
