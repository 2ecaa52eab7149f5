#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

/// The file for a name in a mesh, such as the name of a buffer: a path or the URI of a path (with
/// %20 for a space). Nothing unless it is a regular file in the folder of the mesh or below it,
/// after links are followed.
std::optional<std::filesystem::path> side_file(const std::filesystem::path& name,
                                               const std::filesystem::path& mesh);

/// Throws InputError for a name that is not a side file.
[[noreturn]] void refuse_side_file(const std::string& mesh, const std::string& name);

/// The files that assimp may open: the mesh, under its name for assimp, and its side files. If
/// assimp does not find a side file, it tries others of the same name in the folder of the mesh; it
/// does not get these, since the mesh does not name them. Calls allow_for for opened files.
class MeshFolder : public Assimp::DefaultIOSystem {
  public:
    /// `name` is the name of the mesh for assimp, in the same folder. `contents`, if any, replace
    /// the mesh file, and must outlive this.
    MeshFolder(std::filesystem::path mesh, std::filesystem::path name,
               std::optional<std::string_view> contents);

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;

    /// The side files that were opened.
    const std::set<std::string>& opened() const { return opened_; }
    /// The first requested name that exists but may not be opened, or that assimp would have
    /// replaced by another file.
    const std::string& refused() const { return refused_; }
    /// The first name that was not opened.
    std::string missed() const { return missed_.empty() ? "" : missed_.front().string(); }

  private:
    std::optional<std::filesystem::path> allowed(const std::filesystem::path& file) const;

    std::filesystem::path mesh_, name_;
    std::optional<std::string_view> contents_;
    mutable std::string refused_;
    std::vector<std::filesystem::path> missed_;
    std::set<std::string> opened_;
};

}  // namespace scb::scenes
