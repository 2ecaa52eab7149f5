#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene/scene.h"

namespace scb::scenes {

struct LoadOptions {
    /// The folder to search for meshes that are not beside the scene file, or not at the given
    /// path. Meshes of built-in scenes are only searched here. May be empty.
    std::filesystem::path models_dir;
    std::optional<Pose> pose;  ///< of the second of two mesh files; identity if left open
    /// Logs with the poses of the first and the second of two mesh files, see PoseLogs; empty:
    /// none.
    std::array<std::string, 2> logs{};
    /// Whether poses must be rigid to 1e-9. Else the nearest rotation is taken, see nearest_rigid.
    bool exact_poses = false;
};

/// Loads SCENE of a command line: one built-in name, one scene file (`.json`), one mesh file, or
/// two mesh files. A name that is both a built-in scene and a file means the built-in scene.
///
/// One mesh file gives one body; two give two bodies, the first at the identity pose and the second
/// at `options.pose`, or at the poses of logs, that share one mesh if both are the same file.
/// Bodies are named after their files; two of one name are NAME-A and NAME-B. A relative path that
/// does not exist is also searched in `options.models_dir`. Such scenes are named after the files
/// (bytes that are not UTF-8 become '?', so that the names fit into JSON), have a frame for each
/// row of a log or one frame, and no preferred camera.
///
/// Throws InputError with one sentence: nothing or too much is named, an unknown name (with the
/// possible names, and the nearest built-in name if one is close), poses without two meshes or not
/// rigid, and everything that parse_scene and load_mesh refuse. Throws MeshReaderError as load_mesh
/// does.
Scene load_scene(const std::vector<std::string>& names, const LoadOptions& options = {});

/// The names of the bodies of two mesh files.
std::array<std::string, 2> body_names(const std::string& first, const std::string& second);

/// Whether a name means a scene, built-in or in a file, and not a mesh.
bool names_scene(const std::string& name);

}  // namespace scb::scenes
