#pragma once

#include "core/collide.h"
#include "core/packed_hierarchy.h"
#include "core/simd_level.h"

namespace scb {

/// One side of a query on packed hierarchies, and the mesh it was built from.
template <class Codec>
struct PackedCollider {
    const PackedHierarchy<Codec>& hierarchy;
    const Mesh& mesh;
};

struct PackedOptions {
    SimdLevel level = SimdLevel::best;
};

/// What a query on packed hierarchies found.
struct PackedCollision {
    std::vector<IndexPair> pairs;  ///< triangles of A and B that intersect, sorted
    std::uint64_t n_v = 0;         ///< pairs of volumes that were tested
    std::uint64_t n_p = 0;         ///< pairs of triangles that were tested, in floats
    std::uint64_t n_exact = 0;     ///< of these, pairs that floats could not decide on
};

/// Finds the triangles of A and B that intersect, B moved by `b_to_a` into A's frame: the same
/// pairs as collide() finds on the hierarchies that these were made of, whatever the layout and
/// the level. `b_to_a` must be rigid, see check_rigid. Thread-safe; throws nothing but
/// std::bad_alloc.
template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options = {});

}  // namespace scb
