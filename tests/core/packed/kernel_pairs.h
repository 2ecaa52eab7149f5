#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/packed/packed_query.h"

namespace scb {

/// Two triangles P and Q as the kernel of packed leaves sees them: x, y, z of the edges p1, p2, f1,
/// f2, and of the offset w. See TrianglePairs.
template <class T>
using PairParts = std::array<T, 15>;

/// Of the edges of P, of the edges of Q and of w.
constexpr std::size_t error_of_part(std::size_t i) { return i < 6 ? 0 : i < 12 ? 1 : 2; }

struct KernelPair {
    PairParts<float> seen;
    std::array<float, 3> errors;  ///< of each number at most: of P's edges, Q's edges, and w
};

/// The kernel's results for a pair.
struct KernelAnswer {
    /// Heights of Q's corners above P and of P's above Q; then, row by row, on which side of each
    /// other P's edge i and Q's edge j pass.
    std::array<float, 15> determinants;
    std::array<float, 3> bounds;  ///< of heights above P, of heights above Q, and of sides
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
