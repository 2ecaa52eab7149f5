#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the triangles of a COLLADA file have whole numbers of 32 bits as indices: of others,
/// assimp's reader takes what it can read for one. Those that name no vertex it refuses by itself.
/// Throws InputError that names the file and the place.
void check_collada(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
