#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/platform/json_reader.h"
#include "scb/convex.h"
#include "scb/vec.h"

namespace scb::scenes {

/// A detail of the scene that pictures may magnify: the ball about `center` with this radius, in
/// world coordinates.
struct Inset {
    Vec3 center = Vec3::Zero();
    double radius = 1;
};

/// The view that a scene prefers. Values that are left open are fitted to the content of the
/// picture.
///
/// The camera orbits the target with z up: seen from the target, the camera is in the direction
///     (cos(elevation) sin(azimuth), -cos(elevation) cos(azimuth), sin(elevation)),
/// so azimuth 0 looks along +y with x to the right, and elevation 90 looks straight down.
struct CameraView {
    double azimuth = 30;             ///< degrees
    double elevation = 20;           ///< degrees, -90 to 90
    std::optional<double> distance;  ///< scene units from the target
    std::optional<Vec3> target;      ///< world coordinates
    std::optional<Vec3> up;          ///< world direction; z if left open
    double field_of_view = 35;       ///< degrees, vertical, 1 to 170
    std::optional<bool> orthographic;
    std::optional<double> view_height;  ///< orthographic: scene units from bottom to top
    std::optional<Inset> inset;
    /// Only points p of the world with normal.p <= offset are drawn; the normal has any length but
    /// 0.
    std::optional<FacePlane> clip;
};

/// Parses the value of `--camera`: `fit` (all fitted, default angles),
/// `orbit:AZIMUTH,ELEVATION[,DISTANCE[,X,Y,Z]]`, where X,Y,Z is the target, or the path of a JSON
/// file for parse_camera_json. Throws InputError, naming the option, file and place.
CameraView parse_camera(std::string_view text);

/// The camera object of a scene file, from its JSON text; or the field `camera` of an object that
/// has one, such as a scene file or the index.json beside pictures. `file` is named in errors
/// (InputError).
CameraView parse_camera_json(std::string_view json_text, const std::string& file);

/// The camera object of a scene file, as JSON, which parse_camera_json reads back to the same
/// values.
nlohmann::ordered_json camera_json(const CameraView& camera);

/// The camera object at `place`. Throws InputError, naming file and place.
CameraView read_camera(const JsonPlace& place);

}  // namespace scb::scenes
