#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <set>
#include <string>

namespace scb::scenes {

/// Whether a file that a mesh names, such as a buffer, may be opened: it is a regular file in the
/// folder of the mesh or below it, once links are followed.
bool is_side_file(const std::filesystem::path& file, const std::filesystem::path& mesh);

/// The files that assimp may open: the mesh and its side files. allow_for is told of these.
class MeshFolder : public Assimp::DefaultIOSystem {
  public:
    /// `refused` is set to the first name that was asked for and may not be opened, though
    /// something has it. It must outlive this.
    MeshFolder(std::filesystem::path mesh, std::string& refused);

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;

    /// The side files that were opened.
    const std::set<std::string>& opened() const { return opened_; }

  private:
    bool allows(const char* file) const;

    std::filesystem::path mesh_;
    std::string& refused_;
    std::set<std::string> opened_;
};

}  // namespace scb::scenes
