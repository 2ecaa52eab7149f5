#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A COLLADA file, after check_collada, reduced to its geometries, nodes and scenes: assimp's
/// reader may crash on images without a name, and on skins that name missing things. A skin or
/// morph is replaced by its geometry.
///
/// Every accessor of a geometry is within its array; otherwise assimp's reader would read memory
/// behind the array. Throws InputError that names the array, or the line if the XML is not
/// well-formed.
///
/// Source: Khronos, "COLLADA - Digital Asset Schema Release 1.4.1", accessor and array elements.
std::optional<PlainFile> plain_collada(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
