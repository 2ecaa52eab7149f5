#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the triangles of a 3DS file name vertices that exist: assimp's reader silently
/// replaces missing vertices by the last one. Does not report other errors, which assimp refuses.
/// Throws InputError that names the file, the mesh, the face and the index.
void check_3ds(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
