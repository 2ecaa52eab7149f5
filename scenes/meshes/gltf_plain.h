#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A glTF 2 file, `.gltf` or `.glb`, after check_gltf, reduced to parts that assimp 5.2 reads
/// correctly:
///
/// - integer positions (KHR_mesh_quantization) and sparse numbers are written out as floats and
///   unsigned numbers of 32 bits; Draco's are decompressed to floats;
/// - a file without a scene gets one with all nodes that are not children, or, without nodes, with
///   all meshes;
/// - instances of EXT_mesh_gpu_instancing are nodes;
/// - materials, textures, skins, morph targets, animations, cameras, lights and names are left out.
///
/// The result is a `.glb` if the file is one. Nothing for glTF 1, and for files that are not glTF,
/// which assimp refuses. Throws InputError that names the file and the place, or says that the file
/// is cut off.
///
/// Sources: Khronos, "glTF 2.0 Specification", sections 3.5 and 3.6, and the extensions named.
std::optional<PlainFile> plain_gltf(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
