#pragma once

#include <span>

#include "scb/mesh.h"

namespace scb {

/// Whether two triangles have a vertex in common. `joined`: the joined_vertices of the mesh, or of
/// the same mesh at rest.
inline bool share_vertex(const Mesh& mesh, std::span<const std::uint32_t> joined, std::uint32_t i,
                         std::uint32_t j) {
    for (const std::uint32_t a : mesh.triangles[i])
        for (const std::uint32_t b : mesh.triangles[j])
            if (joined[a] == joined[b]) return true;
    return false;
}

}  // namespace scb
