#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scb/mesh.h"

namespace scb {

/// A mesh without triangles that add nothing to its surface. The vertices stay.
struct CleanMesh {
    Mesh mesh;
    std::vector<std::uint32_t> origin;  ///< per triangle of `mesh`, the triangle of the original
    std::size_t copies = 0;             ///< left out: they have the corners of an earlier triangle
    std::size_t degenerate = 0;         ///< left out, and no copies: their corners are collinear
};

/// Leaves out copies and degenerate triangles; other triangles keep their order. If nothing else is
/// left, the first triangle stays. O(n log n).
CleanMesh clean_mesh(const Mesh& mesh);

}  // namespace scb
