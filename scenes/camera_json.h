#pragma once

#include "scenes/camera_spec.h"
#include "scenes/json_reader.h"

namespace scb {

/// The camera object that stands at `place`. Throws InputError, naming file and place.
CameraSpec read_camera(const JsonPlace& place);

}  // namespace scb
