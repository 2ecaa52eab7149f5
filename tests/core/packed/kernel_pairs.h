#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/packed/packed_query.h"

namespace scb {

/// Two triangles P and Q as the kernel of packed leaves sees them: x, y, z of p1, p2, q0, q1, q2,
/// relative to p0.
using SeenCorners = std::array<float, 15>;

struct KernelPair {
    SeenCorners seen;
    float error;  ///< of each number, at most
};

/// The kernel's results for a pair.
struct KernelAnswer {
    /// Heights of Q's corners above P and of P's above Q; then, row by row, on which side of each
    /// other P's edge i and Q's edge j pass.
    std::array<float, 15> determinants;
    bool planes_meet, intersect, open;

    bool operator==(const KernelAnswer&) const = default;
};

/// Two volumes in two nodes, as the kernel of packed nodes sees them.
template <class Packed>
struct VolumesOfNodes {
    Packed a, b;  ///< relative to the origins of their nodes
    float origin_a[4], origin_b[4], reach_a, reach_b;
};

/// Two triangles of two leaves.
struct LeafLane {
    IndexPair pair;
    KernelPair kernel;
};

}  // namespace scb
