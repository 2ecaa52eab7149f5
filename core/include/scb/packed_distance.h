#pragma once

#include "scb/distance.h"
#include "scb/packed_collide.h"

namespace scb {

/// The result of a distance query on packed hierarchies, and its work.
struct PackedDistance {
    /// The distance of the bodies, and where it was measured, in A's frame. Infinity if there is
    /// nothing within DistanceOptions::limit.
    TriangleDistance found{std::numeric_limits<double>::infinity(), Vec3::Zero(), Vec3::Zero()};
    /// The triangles that have this distance; of several the lowest pair, unless the query ended
    /// early or the distance is 0.
    std::optional<IndexPair> triangles;
    std::uint64_t n_v = 0;        ///< pairs of volumes whose bound was computed
    std::uint64_t n_bounded = 0;  ///< pairs of triangles whose distance was bounded in floats
    std::uint64_t n_p = 0;        ///< pairs of triangles whose distance was computed in doubles
};

/// The smallest distance of a triangle of A and a triangle of B, B moved by `b_to_a` into A's
/// frame: the same bits as distance() finds on the hierarchies that these were packed from, for
/// every layout and level; see there. If the distance is 0, only the distance is the same. Volumes
/// and triangles are bounded in floats, with their errors; distances that may be the least are
/// computed in doubles.
///
/// The options are as in distance(), except that DistanceOptions::descent is not used: of two
/// nodes, the larger is divided. With nodes of 4 or 8 children, the heap may have 2 or 4 times
/// DistanceOptions::heap. Results and counts are the same at every level.
///
/// Runs in the calling thread. Thread-safe; throws nothing but std::bad_alloc.
template <class Codec>
PackedDistance distance_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const DistanceOptions& options = {},
                               SimdLevel level = SimdLevel::best);

/// The triangles within a tolerance, and the work of the query.
struct PackedWithin {
    std::vector<IndexPair> pairs;  ///< triangles of A and B, sorted
    std::uint64_t n_v = 0;         ///< pairs of volumes whose bound was computed
    std::uint64_t n_bounded = 0;   ///< pairs of triangles whose distance was bounded in floats
    std::uint64_t n_p = 0;         ///< pairs of triangles that floats could not decide
};

/// The triangles of A and B whose distance is at most `tolerance`, 0 or more: the same pairs as
/// within() finds. Runs in the calling thread. Thread-safe; throws nothing but std::bad_alloc.
template <class Codec>
PackedWithin within_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                           const Pose& b_to_a, double tolerance, SimdLevel level = SimdLevel::best);

}  // namespace scb
