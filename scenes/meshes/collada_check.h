#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the triangles of a COLLADA file have no negative index: assimp's reader takes such a
/// one for 0. Those that are too large it refuses by itself. Throws InputError that names the file
/// and the place.
void check_collada(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
