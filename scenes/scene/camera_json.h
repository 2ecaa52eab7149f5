#pragma once

#include "scenes/scene/camera_view.h"
#include "scenes/text/json_reader.h"

namespace scb {

/// The camera object that stands at `place`. Throws InputError, naming file and place.
CameraSpec read_camera(const JsonPlace& place);

}  // namespace scb
