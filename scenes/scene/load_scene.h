#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene/scene.h"

namespace scb::scenes {

struct LoadOptions {
    /// Where meshes are looked for that are not where their name says: beside the scene file, or at
    /// the path given; those of built-in scenes are only looked for here. May be empty.
    std::filesystem::path models_dir;
    std::optional<Pose> pose;  ///< of the second of two mesh files; identity where left open
};

/// What a command line names as SCENE: one built-in name, one scene file (`.json`), one mesh file,
/// or two mesh files. A name that is both a built-in scene and a file means the built-in scene.
///
/// One mesh file gives one body; two give two bodies, the first at the identity pose and the second
/// at `options.pose`, that share one mesh where both are the same file. Bodies are named after
/// their files; two of one name are NAME-A and NAME-B. A relative path that leads nowhere is also
/// looked for in `options.models_dir`. Such scenes are named after the files (bytes that are not
/// UTF-8 become '?', so that the names fit into JSON), have one frame and no camera wish.
///
/// Throws InputError with one sentence: nothing or too much is named, an unknown name (with what
/// can be named, and the nearest built-in name where one is close), a pose without two meshes or
/// not rigid, and whatever parse_scene and load_mesh refuse. Throws MeshReaderError as load_mesh
/// does.
Scene load_scene(const std::vector<std::string>& names, const LoadOptions& options = {});

/// Whether a name means a scene, built-in or in a file, and not a mesh.
bool names_scene(const std::string& name);

}  // namespace scb::scenes
