#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that the triangles of a glTF 2 file (`.gltf` or `.glb`) name vertices that exist: every
/// index against the count of the primitive's POSITION accessor; that positions are three floats;
/// and that nothing else in it is what assimp's reader takes for something else without a word:
/// fields that stand twice, damaged base64, the first buffer of a `.glb` with a name, required
/// extensions that it does not know, and transforms of the wrong length.
///
/// Says nothing about what this cannot look into: glTF 1, accessors that are broken, sparse or
/// compressed indices (KHR_draco_mesh_compression, EXT_meshopt_compression). Those are for assimp
/// to read or refuse.
///
/// Throws InputError that names the file and the line or field, or the mesh, primitive and index at
/// fault, or says that the file is cut off.
void check_gltf(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
