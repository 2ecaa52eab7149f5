#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A COLLADA file, after check_collada, with its geometries, nodes and scenes, and nothing else:
/// assimp's reader has been seen to crash on images without a name, and on skins that name what is
/// not there. A skin or morph is its geometry.
///
/// Every accessor of a geometry lies within its array: assimp's reader takes what is behind the
/// array for numbers. Throws InputError that names the array, or the line where the XML is not
/// well-formed.
///
/// Source: Khronos, "COLLADA - Digital Asset Schema Release 1.4.1", accessor and array elements.
std::optional<PlainFile> plain_collada(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
