#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scb/mesh.h"

namespace scb {

/// A mesh with triangles cut into pieces.
struct CutMesh {
    Mesh mesh;
    /// Per triangle of `mesh`, the triangle of the original mesh. Triangles that are not cut keep
    /// their numbers. The first piece of a triangle has the triangle's number, and the other pieces
    /// follow behind all triangles of the original.
    std::vector<std::uint32_t> origin;
    std::size_t cut = 0;     ///< the number of triangles that are cut
    std::size_t pieces = 0;  ///< of these triangles
};

/// Cuts triangles at the midpoints of their longest sides, until no side of a piece is longer than
/// `longest` (M.-C. Rivara, Algorithms for refining triangular grids suitable for adaptive and
/// multigrid techniques, 1984). Starts at `seeds`, and goes on with triangles that share a side
/// longer than `longest` with a cut triangle, so the pieces of neighbors have the same vertices,
/// and a closed mesh stays closed. Without seeds, all triangles with a longer side are cut.
///
/// Midpoints are rounded to double: of coordinates in single precision that differ little in
/// magnitude they are exact. A side without a rounded point between its ends is not cut. Nothing if
/// more than `most_pieces` pieces would be made. `longest` > 0.
std::optional<CutMesh> cut_triangles(const Mesh& mesh, std::span<const std::uint32_t> seeds,
                                     double longest, std::size_t most_pieces);

}  // namespace scb
