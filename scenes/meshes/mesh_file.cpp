#include "scenes/meshes/mesh_file.h"

#include <exception>
#include <new>
#include <string>

#include "scb/error.h"
#include "scenes/meshes/assimp_mesh.h"
#include "scenes/meshes/gltf_check.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/off_check.h"
#include "scenes/meshes/ply_check.h"
#include "scenes/text/file_bytes.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

void check_file(const fs::path& path) {
    const std::string name = path.string();
    check_is_file(name);
    std::error_code error;
    if (fs::file_size(path, error) == 0 && !error)
        throw InputError(name + ": the file is empty; give a mesh as " + mesh_formats + ".");
}

/// The checks that assimp's readers of these formats lack. They go by content as well as by name,
/// as assimp does. True where the file passed one, so that its reader can be trusted with it.
bool check_content(const fs::path& path) {
    const std::string name = path.string(), start = file_bytes(name, 16);
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (extension == ".ply" || start.rfind("ply", 0) == 0) {
        check_ply(file_bytes(name), name);
        return extension == ".ply";
    }
    if (extension == ".off" || start.find("OFF") != std::string::npos)
        check_off(file_bytes(name), name);
    if (extension == ".gltf" || extension == ".glb" || start.rfind("glTF", 0) == 0)
        check_gltf(file_bytes(name), path.parent_path(), name);
    return false;
}

}  // namespace

Mesh load_mesh(const fs::path& path) {
    const std::string name = path.string();
    check_file(path);
    try {
        // assimp's readers of other formats have been seen to crash on broken files.
        Mesh mesh = check_content(path) ? assimp_mesh(name) : isolated_mesh(name);
        check_mesh(mesh, name);
        return mesh;
    } catch (const InputError&) {
        throw;
    } catch (const MeshReaderError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw InputError(
            name + ": needs more memory than there is; give a smaller mesh, or repair its counts.");
    } catch (const std::exception& error) {
        throw InputError(name + ": cannot be read (" + error.what() +
                         "); repair the file or export it again.");
    }
}

}  // namespace scb::scenes
