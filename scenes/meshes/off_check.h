#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks a text OFF file: that the declared vertices and faces are there, and that faces name
/// vertices that exist. assimp's reader quietly bends an index out of range to the last vertex,
/// drops faces that are missing, and allocates whatever is declared, so it only gets files that
/// pass. Files that are not text OFF are left to it.
///
/// Throws InputError that names the file and the vertex or face at fault.
void check_off(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
