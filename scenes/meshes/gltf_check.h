#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the triangles of a glTF 2 file (`.gltf` or `.glb`) name vertices that exist: every
/// index against the count of the primitive's POSITION accessor; and that positions are float.
/// assimp's reader quietly drops triangles that do not, and misreads other positions.
///
/// Says nothing about what this cannot look into: glTF 1, broken files, sparse or compressed
/// indices (KHR_draco_mesh_compression, EXT_meshopt_compression). Those are for assimp to read or
/// refuse.
///
/// Throws InputError that names the file, mesh, primitive and index at fault, or says that the file
/// is cut off.
void check_gltf(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
