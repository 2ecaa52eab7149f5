#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the indices of triangles of a COLLADA file are integers of 32 bits: from other
/// texts, assimp's reader takes the part that it can read. It refuses indices without a vertex
/// itself. Throws InputError that names the file and the place.
void check_collada(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
