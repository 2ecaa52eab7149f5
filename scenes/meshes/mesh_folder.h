#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

/// The file that a mesh means by a name, such as that of a buffer, which is a path or the URI of
/// one (with %20 for a space); nothing unless it is a regular file in the folder of the mesh or
/// below it, once links are followed.
std::optional<std::filesystem::path> side_file(const std::filesystem::path& name,
                                               const std::filesystem::path& mesh);

/// Throws InputError for a name that is no side file.
[[noreturn]] void refuse_side_file(const std::string& mesh, const std::string& name);

/// The files that assimp may open: the mesh, whatever name assimp knows it by, and its side files.
/// Where it does not find one it tries others of the same name, in the folder of the mesh: these
/// are not what the mesh names, so it does not get them. allow_for is told of the files that it
/// opens.
class MeshFolder : public Assimp::DefaultIOSystem {
  public:
    /// `name` is what assimp takes the mesh for, in the same folder; `contents`, where there are
    /// any, are what it gets as the mesh, and must outlive this.
    MeshFolder(std::filesystem::path mesh, std::filesystem::path name,
               std::optional<std::string_view> contents);

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;

    /// The side files that were opened.
    const std::set<std::string>& opened() const { return opened_; }
    /// The first name that was asked for and may not be opened, though something has it, or that
    /// another file would have stood in for.
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
