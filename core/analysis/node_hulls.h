#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hierarchy/mesh_topology.h"
#include "core/hierarchy/tree_shape.h"

namespace scb {

/// Per node of a tree the volume of the convex hull of its points: no convex bounding volume
/// can be smaller.
struct NodeHulls {
    std::vector<double> volumes;
    /// Whether the points lie in no plane, even nearly: the volume of the hull exceeds 1e-9 of the
    /// cubed diagonal of their box. The same for all types of volume.
    std::vector<std::uint8_t> solid;
};

/// Per item (a triangle) of a tree, the ids of its corners: equal positions have one id.
using ItemCorners = std::vector<std::array<std::uint32_t, 3>>;

/// Built from the leaves up, since the vertices of a hull are among the hull vertices of the
/// children. The same for any number of threads. O(n log^2 n) if all vertices are on hulls, as of a
/// sphere; else less.
NodeHulls node_hulls(const TreeShape& shape, const ItemCorners& corners, const PointArrays& points,
                     int threads = 1);

}  // namespace scb
