#pragma once

#include <string>
#include <vector>

namespace scb::scenes {

/// Contents that assimp's reader gets in place of a file.
struct PlainFile {
    std::string bytes;
    std::vector<std::string> left_out{};  ///< parts of the file that are not in the mesh ("skins")
};

}  // namespace scb::scenes
