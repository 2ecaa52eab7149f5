#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenes/meshes/gltf_document.h"

namespace scb::scenes {

/// Whether a primitive has triangles, strips or fans. Throws json::exception.
bool gltf_has_triangles(const nlohmann::json& primitive);
/// Whether its numbers are compressed by KHR_draco_mesh_compression.
bool gltf_is_in_draco(const nlohmann::json& primitive);

/// Calls the function with each primitive, and the begin of messages about it. A json::exception
/// becomes an InputError.
void for_each_primitive(GltfDocument& document,
                        const std::function<void(nlohmann::json&, const std::string&)>& action);

/// Checks that the triangles of a glTF 2 file (`.gltf` or `.glb`) name vertices that exist: every
/// index against the count of the primitive's POSITION accessor; that positions are three numbers
/// each and lie within their buffer view; and that it has nothing that assimp's reader would
/// silently misread: fields that occur twice, damaged base64, the first buffer of a `.glb` with a
/// name (`has_chunks`: it is a .glb), unknown required extensions, and transforms of the wrong
/// length. `root` must have an array `meshes`.
///
/// Does not check accessors with other errors, or compressed indices (KHR_draco_mesh_compression,
/// EXT_meshopt_compression). assimp reads or refuses those.
///
/// Throws InputError that names the file and the line or field, or the mesh, primitive and index at
/// fault.
void check_gltf(GltfDocument& document, bool has_chunks);

}  // namespace scb::scenes
