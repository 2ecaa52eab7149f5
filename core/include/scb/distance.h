#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scb/collide.h"
#include "scb/triangle_distance.h"

namespace scb {

/// The order in which a distance query divides pairs of nodes.
enum class DistanceOrder {
    nearest,      ///< the pair with the least bound, by a heap: the fewest tests
    depth_first,  ///< the nearer child first: little memory
    hybrid,       ///< nearest up to a size of the heap, then each of its pairs depth first
};

/// "nearest", "depth-first", "hybrid".
std::string_view distance_order_name(DistanceOrder order);
/// The order with this name; no value if no order has the name.
std::optional<DistanceOrder> distance_order_of(std::string_view name);

/// How a distance query runs. With the default limits the distance does not depend on the order.
struct DistanceOptions {
    /// The order of the traversal.
    DistanceOrder order = DistanceOrder::hybrid;
    /// Which of two nodes is divided.
    DescentRule descent = DescentRule::radius;
    /// The size of the heap for DistanceOrder::hybrid.
    std::size_t heap = 256;
    /// The query ends once it has found two triangles no farther apart: "is anything within this
    /// distance?" Negative: it ends at the smallest distance.
    double enough = -1;
    /// Pairs of nodes are skipped unless their bound is below the distance so far, over 1 plus this
    /// number. The answer is then at most so much too large. 0 or more.
    double relative_error = 0;
    /// Triangles of A and B to begin with, such as the closest pair of the frame before: the nearer
    /// they are, the fewer tests follow.
    std::optional<IndexPair> seed = std::nullopt;
    /// Nothing beyond this distance is looked for.
    double limit = std::numeric_limits<double>::infinity();
};

/// The result of a distance query, and its work.
struct Distance {
    /// The distance of the bodies, and where it was measured, in A's frame. Infinity if there is
    /// nothing within DistanceOptions::limit.
    TriangleDistance found{std::numeric_limits<double>::infinity(), Vec3::Zero(), Vec3::Zero()};
    /// The triangles that have this distance; of several the lowest pair, unless the query ended
    /// early or the distance is 0.
    std::optional<IndexPair> triangles;
    std::uint64_t n_v = 0;  ///< pairs of volumes whose bound was computed
    std::uint64_t n_p = 0;  ///< pairs of triangles whose distance was computed
    std::uint64_t n_u = 0;  ///< points and directions of volumes transformed for these bounds
    StageCounts stages{};   ///< of the volumes by the largest bound
};

/// The smallest distance of a triangle of A and a triangle of B, B moved by `b_to_a` into A's
/// frame; 0 if and only if some triangles intersect. Bodies inside of each other have the distance
/// of their surfaces. Distances are of the corners as transform_point rounds them. Without limits,
/// errors and `enough`, the result is the same for each volume, order, split and seed; if the
/// distance is 0, only the distance is. `b_to_a` must be rigid, see check_rigid. Thread-safe;
/// throws nothing but std::bad_alloc.
///
/// The traversal is after Larsen, Gottschalk, Lin and Manocha, "Fast Proximity Queries with Swept
/// Sphere Volumes" (1999), with a heap as in Johnson and Cohen, "A Framework for Efficient Minimum
/// Distance Computations" (1998).
template <Volume V>
Distance distance(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const DistanceOptions& options = {});

/// The same, and `recorder` keeps every test. A step that ended as `overlapping` was nearer than
/// the answer so far; ItemStep::hit is whether the triangles became the answer. Also throws
/// std::length_error as collide does.
template <Volume V>
Distance distance(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const DistanceOptions& options, StepRecorder& recorder);

/// The triangles of A and B whose distance is at most `tolerance`, 0 or more, sorted, and the work
/// of the query. Thread-safe; throws nothing but std::bad_alloc.
template <Volume V>
Collision within(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, double tolerance,
                 DescentRule descent = DescentRule::radius);

/// The same, and `recorder` keeps every test; ItemStep::hit is whether the triangles are within the
/// tolerance. Also throws std::length_error as collide does.
template <Volume V>
Collision within(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, double tolerance,
                 DescentRule descent, StepRecorder& recorder);

}  // namespace scb
