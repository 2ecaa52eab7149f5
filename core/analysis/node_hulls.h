#pragma once

#include <cstdint>
#include <vector>

#include "core/hierarchy/leaf_order.h"
#include "scb/topology.h"

namespace scb {

/// Per node of a topology the volume of the convex hull of its points: no convex bounding volume
/// can be smaller.
struct NodeHulls {
    std::vector<double> volumes;
    /// Whether the points lie in no plane, not even nearly: the hull has more than 1e-9 of the cube
    /// of the diagonal of their box. The same for all types of volume.
    std::vector<std::uint8_t> solid;
};

/// From the leaves up, since the vertices of a hull are among those of its children's. The same for
/// any number of threads. O(n log^2 n) where all vertices are on hulls, as of a sphere; else less.
NodeHulls node_hulls(const Topology& topology, const LeafOrder& points, int threads = 1);

}  // namespace scb
