#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"

namespace scb::scenes {

// In place of mesh_file.cpp if the library is built without assimp.
Mesh load_mesh(const std::filesystem::path& path) {
    throw InputError(path.string() +
                     ": this build reads no mesh files; build with SCB_BUILD_APP=ON.");
}

}  // namespace scb::scenes
