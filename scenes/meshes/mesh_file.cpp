#include "scenes/meshes/mesh_file.h"

#include <exception>
#include <new>
#include <string>

#include "scb/error.h"
#include "scenes/meshes/assimp_mesh.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/obj_mesh.h"
#include "scenes/meshes/ply_mesh.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/input_files.h"

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

/// By content as well as by name.
bool is_ply(const std::string& path) {
    if (lower_case_extension(path) == ".ply") return true;
    std::string start = file_bytes(path, 4);
    for (char& c : start)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return start.starts_with("ply") && start.find_first_of(" \t\r\n", 3) == 3;
}

}  // namespace

Mesh load_mesh(const fs::path& path) {
    const std::string name = path.string();
    check_file(path);
    note_input(path);
    try {
        // assimp's readers have been seen to crash on broken files.
        Mesh mesh = is_ply(name)                           ? ply_mesh(name)
                    : lower_case_extension(name) == ".obj" ? obj_mesh(name)
                                                           : isolated_mesh(name);
        check_mesh(mesh, name);
        return mesh;
    } catch (const InputError&) {
        throw;
    } catch (const MeshReaderError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MeshReaderError(name +
                              ": needs more memory than there is; give a smaller mesh, or a higher "
                              "limit (ulimit -v).");
    } catch (const std::exception& error) {
        throw InputError(name + ": cannot be read (" + error.what() +
                         "); repair the file or export it again.");
    }
}

}  // namespace scb::scenes
