#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/points.h"
#include "scb/topology.h"

namespace scb {

/// The points of a mesh in the order in which the leaves of a topology first use them, equal
/// positions joined to one point (0 and -0 are equal). A node's points are then its own, a
/// contiguous range, and a few with smaller ids, which it shares with triangles left of it. A soup
/// and an indexed mesh of the same triangles have the same points.
struct LeafOrder {
    PointArrays points;  ///< by point id
    std::vector<std::array<std::uint32_t, 3>>
        corners;  ///< point ids per position in Topology::order
    /// Per position in Topology::order, and behind the last: the number of points in the leaves
    /// before it. A node's own points are from own_first[first] to own_first[first + count].
    std::vector<std::uint32_t> own_first;
};

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology);

/// The same; `welded` are the joined_vertices of the mesh.
LeafOrder leaf_order(const Mesh& mesh, const Topology& topology,
                     const std::vector<std::uint32_t>& welded, int threads = 1);

}  // namespace scb
