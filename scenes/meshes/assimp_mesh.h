#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scb/mesh.h"
#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A mesh, the other files that it was read from, and what of the file is not in it ("skins").
struct AssimpMesh {
    Mesh mesh;
    std::vector<std::string> side_files;
    std::vector<std::string> left_out;
};

/// The meshes of a file as assimp reads them, placed by their nodes and joined (see load_mesh), not
/// yet checked. Not of OBJ, PLY and OFF files, which have readers of their own. Throws InputError;
/// what else the library throws passes through.
///
/// `plain` is what assimp reads in place of the file, where it is given. `ending` is added to the
/// name that assimp knows the file by.
///
/// assimp's scene is never freed: to free it has been seen to crash, so a process that calls this
/// ends soon, by _exit.
AssimpMesh assimp_mesh(const std::string& path, const std::optional<PlainFile>& plain,
                       const std::string& ending);

/// The formats to name where none fits.
inline constexpr const char* mesh_formats =
    "OBJ, PLY, STL, OFF, glTF, GLB, DAE, 3DS, FBX or another format that assimp reads";

}  // namespace scb::scenes
