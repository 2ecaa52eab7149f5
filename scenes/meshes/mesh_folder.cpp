#include "scenes/meshes/mesh_folder.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/confinement.h"

namespace scb::scenes {

namespace fs = std::filesystem;

namespace {

/// RFC 3986, section 2.1. Control characters stay encoded.
std::string percent_decoded(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char value = 0;
        const char* const end = uri.data() + std::min(i + 3, uri.size());
        if (uri[i] == '%' && std::from_chars(uri.data() + i + 1, end, value, 16).ptr == end &&
            value >= ' ' && end - uri.data() == static_cast<std::ptrdiff_t>(i + 3)) {
            decoded += static_cast<char>(value);
            i += 2;
        } else {
            decoded += uri[i];
        }
    }
    return decoded;
}

bool is_in_folder(const fs::path& file, const fs::path& mesh) {
    std::error_code error;
    const fs::path parent = mesh.parent_path();
    const fs::path folder = fs::canonical(parent.empty() ? "." : parent, error);
    if (error) return false;
    const fs::path target = fs::canonical(file, error);
    if (error || !fs::is_regular_file(target, error)) return false;
    return std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first ==
           folder.end();
}

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

}  // namespace

std::optional<fs::path> side_file(const fs::path& name, const fs::path& mesh) {
    if (is_in_folder(name, mesh)) return name;
    const std::string folder = mesh.parent_path().string(), whole = name.string();
    const std::size_t uri = whole.starts_with(folder) ? folder.size() : 0;
    const fs::path decoded = whole.substr(0, uri) + percent_decoded(whole.substr(uri));
    if (decoded != name && is_in_folder(decoded, mesh)) return decoded;
    return std::nullopt;
}

void refuse_side_file(const std::string& mesh, const std::string& name) {
    throw InputError(mesh + ": names \"" + excerpt(name) +
                     "\", which is not a regular file in the folder of the mesh; put a copy there, "
                     "and name that.");
}

MeshFolder::MeshFolder(fs::path mesh, fs::path name, std::optional<std::string_view> contents)
    : mesh_(std::move(mesh)), name_(std::move(name)), contents_(contents) {}

std::optional<fs::path> MeshFolder::allowed(const fs::path& file) const {
    if (file == mesh_ || file == name_) return mesh_;
    const std::optional<fs::path> found = side_file(file, mesh_);
    const fs::path folder = mesh_.parent_path(), normal = file.lexically_normal();
    std::string refused;
    if (found) {
        for (const fs::path& missed : missed_)
            if (missed.filename() == file.filename() && missed.lexically_normal() != normal &&
                (folder / missed).lexically_normal() != normal)
                refused = missed.string();
    } else if (is_there(file)) {
        refused = file.string();
    }
    if (refused.empty()) return found;
    if (refused_.empty()) refused_ = refused;
    return std::nullopt;
}

bool MeshFolder::Exists(const char* file) const { return allowed(file).has_value(); }

Assimp::IOStream* MeshFolder::Open(const char* file, const char* mode) {
    const std::optional<fs::path> found = allowed(file);
    if (!found) {
        std::string name = file;
        std::replace(name.begin(), name.end(), '\\', '/');
        missed_.emplace_back(name);
        return nullptr;
    }
    if (*found == mesh_ && contents_)
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(contents_->data()),
                                          contents_->size());
    // assimp's readers open a file more than once.
    std::error_code error;
    const std::uintmax_t size = fs::file_size(*found, error);
    if (!error && *found != mesh_ && opened_.insert(found->string()).second) allow_for(size);
    return DefaultIOSystem::Open(found->c_str(), mode);
}

}  // namespace scb::scenes
