#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scb/hierarchy.h"
#include "scb/observer.h"
#include "scb/overlap_options.h"
#include "scb/pose.h"
#include "scb/step_recorder.h"

namespace scb {

/// The kinds of queries.
enum class QueryKind : std::uint8_t {
    collide,   ///< the intersecting triangles of two bodies
    self,      ///< the intersecting triangles of one body, see collide_self
    distance,  ///< the closest triangles of two bodies, see distance.h
    within,    ///< the triangles of two bodies within a distance, see distance.h
};

/// "collide", "self", "distance", "within".
std::string_view query_kind_name(QueryKind kind);

/// Which of two overlapping nodes is divided: A's node if its size is not below the size of B's, so
/// a tie divides A. If one cannot be divided, the other is.
enum class DescentRule {
    radius,       ///< the larger descent_size: the paper's rule (Section 5)
    area,         ///< the larger surface area
    volume,       ///< the larger volume
    alternating,  ///< in turn, A first
};

/// "radius", "area", "volume", "alternating".
std::string_view descent_rule_name(DescentRule rule);
/// The rule with this name; no value if no rule has the name.
std::optional<DescentRule> descent_rule_of(std::string_view name);
/// All rules, in the order in which they are declared.
std::span<const DescentRule> all_descent_rules();

/// One side of a query: a hierarchy and the mesh it was built from, both in the body frame. Refers,
/// does not own.
template <Volume V>
struct Collider {
    /// The hierarchy.
    const Hierarchy<V>& hierarchy;
    /// The mesh; pairs have its indices.
    const Mesh& mesh;
};

/// The one side of a self query. Refers, does not own.
template <Volume V>
struct SelfCollider {
    /// The hierarchy.
    const Hierarchy<V>& hierarchy;
    /// The mesh; pairs have its indices.
    const Mesh& mesh;
    /// Per vertex, the vertex that represents all at its position, see joined_vertices. Triangles
    /// with a common representative are neighbors, and never a pair.
    std::span<const std::uint32_t> joined;
};

/// How a query runs, and when it ends.
struct CollideOptions {
    /// How two volumes are tested; ignored for volumes other than Scb.
    OverlapOptions overlap;
    /// Which of two nodes that overlap is divided.
    DescentRule descent = DescentRule::radius;
    /// The query ends after this many pairs, at least 1, which finds the first contact. The order
    /// of the traversal determines the pairs.
    std::size_t max_pairs = std::numeric_limits<std::size_t>::max();
    /// Nodes at this depth count as leaves, and no triangles are tested: the query finds pairs of
    /// nodes of the two covers of this level, see level_cover. Negative: no such level.
    int stop_level = -1;
};

/// The result of a query, and its work, with the symbols of equation 1 of the paper.
struct Collision {
    std::vector<IndexPair> pairs;  ///< triangles that intersect, or nodes of `stop_level` that
                                   ///< overlap; sorted, each once
    std::uint64_t n_v = 0;         ///< tests of two volumes, tests of two leaves included
    std::uint64_t n_p = 0;         ///< tests of two triangles
    std::uint64_t n_u = 0;         ///< points and directions of volumes transformed for these tests
    StageCounts stages{};          ///< volume tests by how they ended; their sum is n_v
    int depth = 0;         ///< of the deepest volume test: the sum of the depths of its two nodes
    bool complete = true;  ///< false if `max_pairs` ended the query: there may be more pairs
};

/// Finds the triangles of A and B that intersect, B moved by `b_to_a` into A's frame: one dual
/// traversal of the two hierarchies. Both children of a divided node are tested at once. If both
/// overlap, the second is divided first.
///
/// Triangles are closed sets, and tested exactly as they are in A's frame: corners of A as stored,
/// corners of B as transform_point rounds them. `b_to_a` must be rigid, see check_rigid and
/// relative_pose. Thread-safe; throws nothing but std::bad_alloc; allocates for the result and a
/// stack only. Defined for the types of volume.h. The counts depend on the arguments alone,
/// not on how the caller is compiled.
template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options = {});

/// The same, and `recorder` keeps every test. Also throws std::length_error, for more than 2^32 - 1
/// tests of volumes or a node deeper than 65,535.
template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, StepRecorder& recorder);

/// The same, and `calls` receives every test. Its exceptions end the query and reach the caller.
template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, const ObserverCalls& calls);

/// The same with an observer of the caller's type, at the price of one function call per test.
template <Volume V, Observer O>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, O& observer) {
    return collide(a, b, b_to_a, options, calls_of(observer));
}

/// Finds the triangles of one mesh that intersect and share no vertex: each pair once, the lower
/// triangle first. The left part of each node is tested against its right part, so that a query has
/// as many steps without a parent as the hierarchy has inner nodes. In a pair of nodes of
/// `stop_level`, the left node is first. Otherwise as collide.
template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options = {});

/// The same, and `recorder` keeps every test.
template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options,
                       StepRecorder& recorder);

/// The same, and `calls` receives every test.
template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options,
                       const ObserverCalls& calls);

}  // namespace scb
