#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace scb {

/// How many triangles each mesh primitive of a glTF 2 file declares, in file order, from its JSON
/// (`.gltf` or the first chunk of `.glb`); zero for primitives that are not triangle lists. Empty
/// where this cannot be told.
///
/// assimp's reader quietly drops triangles with an index out of range; comparing with this brings
/// that to light.
std::vector<std::size_t> gltf_triangle_counts(std::string_view bytes);

}  // namespace scb
