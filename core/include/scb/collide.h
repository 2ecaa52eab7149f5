#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/collide/transform_count.h"
#include "scb/descent_rule.h"
#include "scb/hierarchy.h"
#include "scb/observer.h"
#include "scb/overlap.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// One side of a query: a hierarchy and the mesh it was built from, both in the body frame. Refers,
/// does not own.
template <Volume V>
struct Collider {
    const Hierarchy<V>& hierarchy;
    const Mesh& mesh;
};

struct CollideOptions {
    OverlapOptions overlap;
    DescentRule descent = DescentRule::radius;
    /// The query ends once it has found so many pairs, at least 1: for the first contact. Which
    /// pairs those are follows from the order of the traversal.
    std::size_t max_pairs = std::numeric_limits<std::size_t>::max();
    /// Nodes at this depth count as leaves, and no triangles are tested: the pairs that are found
    /// are pairs of nodes of the two covers of this level, see level_cover. Negative: no such
    /// level.
    int stop_level = -1;
};

/// Where B is for a query on whole hierarchies: their volumes below the root may stick out of it.
template <Volume V>
Placement query_placement(const Hierarchy<V>& a, const Hierarchy<V>& b, const Pose& b_to_a) {
    // The center of a fitted volume is among its points, which are in the root, and its size is at
    // most some diameters of them.
    return placement(b_to_a, 4 * reach(a.volumes[0]), 4 * reach(b.volumes[0]));
}

/// The triangle's corners, in the body frame.
inline TriangleCorners corners(const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// The same seen from another frame.
inline TriangleCorners transform_corners(const Pose& pose, const TriangleCorners& t) {
    return {transform_point(pose, t[0]), transform_point(pose, t[1]), transform_point(pose, t[2])};
}

namespace detail {

/// The traversal, compiled for one volume type, overlap test, descent rule and observer.
template <DescentRule rule, Volume V, class Test, class Observer>
void traverse(const Collider<V>& a, const Collider<V>& b, const Placement& placed, const Test& test,
              const CollideOptions& options, Observer& observer, Collision& result) {
    const Topology& topology_a = *a.hierarchy.topology;
    const Topology& topology_b = *b.hierarchy.topology;
    const TopologyNode* const nodes_a = topology_a.nodes.data();
    const TopologyNode* const nodes_b = topology_b.nodes.data();
    const V* const volumes_a = a.hierarchy.volumes.data();
    const V* const volumes_b = b.hierarchy.volumes.data();

    // Pairs that overlap and are to be divided. Each division leaves at most one pair behind on
    // the way down, so the stack is no longer than the two depths together.
    struct Pending {
        std::uint32_t a, b;
        int depth_a, depth_b;
    };
    std::vector<Pending> pending;
    pending.reserve(256);

    const auto found = [&](std::uint32_t i, std::uint32_t j) {
        result.pairs.push_back({i, j});
        if (result.pairs.size() >= options.max_pairs) result.complete = false;
    };
    // A pair that overlaps is tested for triangles at once, or divided later. The observer is an
    // argument, since as a capture it would be stored even where there is nothing to tell.
    const auto visit = [&](Told<Observer> told, std::uint32_t i, std::uint32_t j, int depth_a,
                           int depth_b) {
        const Stage stage = test(volumes_a[i], volumes_b[j], placed);
        ++result.stages[static_cast<std::size_t>(stage)];
        if constexpr (observed<Observer>) told.volume_test({i, j}, depth_a, depth_b, stage);
        if (stage != Stage::overlapping) return;
        const bool at_end_a = nodes_a[i].is_leaf() || depth_a == options.stop_level;
        const bool at_end_b = nodes_b[j].is_leaf() || depth_b == options.stop_level;
        if (!at_end_a || !at_end_b) {
            pending.push_back({i, j, depth_a, depth_b});
            return;
        }
        if (options.stop_level >= 0) return found(i, j);
        const std::uint32_t triangle_a = topology_a.order[nodes_a[i].first];
        const std::uint32_t triangle_b = topology_b.order[nodes_b[j].first];
        ++result.n_p;
        const bool intersect =
            triangles_overlap(corners(a.mesh, triangle_a),
                              transform_corners(placed.b_to_a, corners(b.mesh, triangle_b)));
        if constexpr (observed<Observer>) told.triangle_test({triangle_a, triangle_b}, intersect);
        if (intersect) found(triangle_a, triangle_b);
    };

    visit(observer, 0, 0, 0, 0);
    while (!pending.empty() && result.complete) {
        const Pending p = pending.back();
        pending.pop_back();
        const int depth = p.depth_a + p.depth_b;
        result.depth = std::max(result.depth, depth + 1);
        const bool at_end_a = nodes_a[p.a].is_leaf() || p.depth_a == options.stop_level;
        const bool at_end_b = nodes_b[p.b].is_leaf() || p.depth_b == options.stop_level;
        if (at_end_b ||
            (!at_end_a && descends_into_a<rule>(volumes_a[p.a], volumes_b[p.b], depth))) {
            const std::uint32_t left = nodes_a[p.a].left;
            visit(observer, left, p.b, p.depth_a + 1, p.depth_b);
            if (result.complete) visit(observer, left + 1, p.b, p.depth_a + 1, p.depth_b);
        } else {
            const std::uint32_t left = nodes_b[p.b].left;
            visit(observer, p.a, left, p.depth_a, p.depth_b + 1);
            if (result.complete) visit(observer, p.a, left + 1, p.depth_a, p.depth_b + 1);
        }
    }
}

}  // namespace detail

/// Finds the triangles of A and B that intersect, B moved by `b_to_a` into A's frame: one dual
/// traversal of the two hierarchies, as an explicit stack. Both children of the node that is
/// divided are tested at once, and of those that overlap the second is divided first.
///
/// Triangles are closed sets, and tested exactly as they are in A's frame: corners of A as stored,
/// corners of B as transform_point rounds them. `b_to_a` must be rigid, see check_rigid and
/// relative_pose. `observer` is any type with NoObserver's functions. Thread-safe; nothing throws
/// but std::bad_alloc; allocates for the result and the stack only.
template <Volume V, class Observer = NoObserver>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options = {}, Observer&& observer = {}) {
    Collision result;
    const Placement placed = query_placement(a.hierarchy, b.hierarchy, b_to_a);
    with_overlap_test<V>(options.overlap, [&](const auto& test) {
        const auto run = [&]<DescentRule rule>() {
            detail::traverse<rule>(a, b, placed, test, options, observer, result);
        };
        switch (options.descent) {
            case DescentRule::radius:
                return run.template operator()<DescentRule::radius>();
            case DescentRule::area:
                return run.template operator()<DescentRule::area>();
            case DescentRule::volume:
                return run.template operator()<DescentRule::volume>();
            case DescentRule::alternating:
                return run.template operator()<DescentRule::alternating>();
        }
    });
    result.n_v = test_count(result.stages);
    result.n_u = transform_count<V>(result.stages, options.overlap);
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

}  // namespace scb
