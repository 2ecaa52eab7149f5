#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scb/mesh.h"
#include "scb/pose.h"
#include "scb/step.h"

namespace scb {

/// A connected set of the pairs that a query found: one place where two bodies meet. Two pairs are
/// neighbors if their triangles of A have a common corner, and their triangles of B too. Corners at
/// equal positions are one corner.
struct ContactPatch {
    std::vector<std::uint32_t> pairs;  ///< numbers of the pairs in the query's list, ascending
    /// Holds the points in which the triangles of its pairs meet, in A's frame; rounded.
    Box box;
};

/// One side of a query.
struct PatchSide {
    const Mesh& mesh;
    const std::vector<Triangle>& joined;  ///< joined_triangles of the mesh
};

/// The patches of all pairs, the most pairs first; of patches with as many pairs, the patch with
/// the lowest pair is first. `is_self`: the pairs are of one body, and either triangle of a pair
/// may be the neighbor of either triangle of another. O(n) for the partition of n pairs, apart from
/// the joining of sets.
std::vector<ContactPatch> contact_patches(const PatchSide& a, const PatchSide& b,
                                          const Pose& b_to_a, std::span<const IndexPair> pairs,
                                          bool is_self = false);

/// The triangles of one side (0: A) of a patch, ascending, each once.
std::vector<std::uint32_t> triangles_of(const ContactPatch& patch, std::span<const IndexPair> pairs,
                                        std::size_t side);

}  // namespace scb
