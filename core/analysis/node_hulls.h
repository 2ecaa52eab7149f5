#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hierarchy/leaf_order.h"
#include "core/hierarchy/tree_shape.h"

namespace scb {

/// Per node of a tree the volume of the convex hull of its points: no convex bounding volume
/// can be smaller.
struct NodeHulls {
    std::vector<double> volumes;
    /// Whether the points lie in no plane, not even nearly: the hull has more than 1e-9 of the cube
    /// of the diagonal of their box. The same for all types of volume.
    std::vector<std::uint8_t> solid;
};

/// Per item of a tree, a triangle, the ids of its corners: equal positions have one id.
using ItemCorners = std::vector<std::array<std::uint32_t, 3>>;

/// From the leaves up, since the vertices of a hull are among those of its children's. The same for
/// any number of threads. O(n log^2 n) where all vertices are on hulls, as of a sphere; else less.
NodeHulls node_hulls(const TreeShape& shape, const ItemCorners& corners, const PointArrays& points,
                     int threads = 1);

}  // namespace scb
