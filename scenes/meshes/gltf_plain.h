#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenes/meshes/plain_file.h"

namespace scb::scenes {

/// A glTF 2 file, `.gltf` or `.glb`, after check_gltf, with what assimp 5.2 reads of it right, and
/// nothing else:
///
/// - positions of whole numbers (KHR_mesh_quantization) and sparse numbers are written out as
///   floats and unsigned numbers of 32 bits; Draco's are unpacked as floats;
/// - a file without a scene has one of all nodes that are no children, or without nodes one of all
///   meshes;
/// - instances of EXT_mesh_gpu_instancing are nodes;
/// - materials, textures, skins, morph targets, animations, cameras, lights and names are left out.
///
/// The result is a `.glb` where the file is one. Nothing for glTF 1, and for files that are no
/// glTF, which assimp refuses. Throws InputError that names the file and the place, or says that
/// the file is cut off.
///
/// Sources: Khronos, "glTF 2.0 Specification", sections 3.5 and 3.6, and the extensions named.
std::optional<PlainFile> plain_gltf(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
