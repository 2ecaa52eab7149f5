#include "scenes/meshes/mesh_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "scenes/meshes/confinement.h"

namespace scb::scenes {

namespace fs = std::filesystem;

bool is_side_file(const fs::path& file, const fs::path& mesh) {
    std::error_code error;
    const fs::path parent = mesh.parent_path();
    const fs::path folder = fs::canonical(parent.empty() ? "." : parent, error);
    if (error) return false;
    const fs::path target = fs::canonical(file, error);
    if (error || !fs::is_regular_file(target, error)) return false;
    return std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first ==
           folder.end();
}

MeshFolder::MeshFolder(fs::path mesh, std::string& refused)
    : mesh_(std::move(mesh)), refused_(refused) {}

bool MeshFolder::allows(const char* file) const {
    std::error_code error;
    if (file == mesh_ || is_side_file(file, mesh_)) return true;
    if (refused_.empty() && fs::exists(fs::symlink_status(file, error))) refused_ = file;
    return false;
}

bool MeshFolder::Exists(const char* file) const {
    return allows(file) && DefaultIOSystem::Exists(file);
}

Assimp::IOStream* MeshFolder::Open(const char* file, const char* mode) {
    if (!allows(file)) return nullptr;
    // Its readers open a file more than once.
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && file != mesh_ && opened_.insert(file).second) allow_for(size);
    return DefaultIOSystem::Open(file, mode);
}

}  // namespace scb::scenes
