#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scb/mesh.h"

namespace scb {

/// The mesh's triangles with equal corners joined: each corner becomes the first vertex, by index,
/// at its place (0 and -0 are equal). The vertices that triangles use must be finite. O(n log n).
std::vector<Triangle> joined_triangles(const Mesh& mesh);

/// The parts of a mesh: triangles connected by common corners.
struct MeshParts {
    std::size_t count = 0;
    std::vector<std::uint32_t> of_triangle;  ///< per triangle its part; parts are ordered by their
                                             ///< first triangles
};

/// The parts of joined triangles, whose corners are below `vertices`.
MeshParts mesh_parts(const std::vector<Triangle>& joined, std::size_t vertices);

/// For each edge of the joined triangles, the number of triangles that have it.
std::vector<std::uint32_t> edge_uses(const std::vector<Triangle>& joined);

/// Whether the joined triangles bound a solid: every edge is in an even number of them. Triangles
/// that have one corner twice are left out.
bool are_closed(std::vector<Triangle> joined);

}  // namespace scb
