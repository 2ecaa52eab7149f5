#pragma once

#include <string>
#include <vector>

#include "scb/mesh.h"

namespace scb::scenes {

/// A mesh, and the other files that it was read from.
struct AssimpMesh {
    Mesh mesh;
    std::vector<std::string> side_files;
};

/// The meshes of a file as assimp reads them, placed by their nodes and joined (see load_mesh), not
/// yet checked. Not of OBJ and PLY files, which have readers of their own. Throws InputError; what
/// else the library throws passes through.
AssimpMesh assimp_mesh(const std::string& path);

/// The formats to name where none fits.
inline constexpr const char* mesh_formats =
    "OBJ, PLY, STL, OFF, glTF, GLB, DAE, 3DS, FBX or another format that assimp reads";

}  // namespace scb::scenes
