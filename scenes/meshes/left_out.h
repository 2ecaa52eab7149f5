#pragma once

#include <string>
#include <vector>

namespace scb::scenes {

/// Notes parts of a mesh file that are not in the mesh: "skins", "morph targets". Any thread may
/// call this.
void note_left_out(const std::string& file, const std::vector<std::string>& what);

/// A sentence for each file that was noted since the last call, in the order of their names.
std::vector<std::string> take_left_out();

}  // namespace scb::scenes
