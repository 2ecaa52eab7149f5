#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scb/mesh.h"
#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A mesh, the other files that it was read from, and the parts of the file that are not in it
/// ("skins").
struct AssimpMesh {
    Mesh mesh;
    std::vector<std::string> side_files;
    std::vector<std::string> left_out;
};

/// The meshes of a file as assimp reads them, placed by their nodes and joined (see load_mesh), not
/// yet checked. Not for OBJ, PLY and OFF files, which have readers of their own. Throws InputError;
/// other exceptions of the library pass through.
///
/// `plain`: if given, assimp reads it in place of the file. `ending` is added to the file's name
/// for assimp.
///
/// assimp's scene is never freed, since that may crash. So a process that calls this must end soon,
/// by _exit.
AssimpMesh assimp_mesh(const std::string& path, const std::optional<PlainFile>& plain,
                       const std::string& ending);

/// The formats to name if none fits.
inline constexpr const char* mesh_formats =
    "OBJ, PLY, STL, OFF, glTF, GLB, DAE, 3DS, FBX or another format that assimp reads";

}  // namespace scb::scenes
