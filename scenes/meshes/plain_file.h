#pragma once

#include <string>
#include <vector>

namespace scb::scenes {

/// A file as assimp's reader of its format gets it, in place of the file.
struct PlainFile {
    std::string bytes;
    std::vector<std::string> left_out{};  ///< what of the file has no place in a mesh ("skins")
};

}  // namespace scb::scenes
