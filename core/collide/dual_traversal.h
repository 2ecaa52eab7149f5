#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/collide/query_placement.h"
#include "core/geometry/triangle_pair.h"
#include "core/overlap/test_functors.h"
#include "core/traverse/traverse.h"
#include "scb/collide.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// The area and the volume that decide which node is divided. Convex volumes have quicker measures
/// for this purpose.
template <Volume V>
double descent_area(const V& v) {
    if constexpr (ConvexVolume<V>)
        return descent_measures(v).area;
    else
        return surface_area(v);
}
template <Volume V>
double descent_volume(const V& v) {
    if constexpr (ConvexVolume<V>)
        return descent_measures(v).volume;
    else
        return volume(v);
}

/// Whether A's node is divided, not B's. `depth`: the depths of both nodes added.
template <DescentRule rule, Volume V>
bool descends_into_a(const V& a, const V& b, int depth) {
    if constexpr (rule == DescentRule::radius) return descent_size(a) >= descent_size(b);
    if constexpr (rule == DescentRule::area) return descent_area(a) >= descent_area(b);
    if constexpr (rule == DescentRule::volume) return descent_volume(a) >= descent_volume(b);
    return depth % 2 == 0;
}

/// N_u of equation 1: the points and directions of B's volumes that these tests transformed. Balls
/// and boxes along the body's axes: the center. Slab cut balls: the center, and the normal if the
/// test gets that far. Oriented boxes: the center and three axes. Two slabs: the center and, after
/// the balls, both normals. Convex volumes: the center, and a direction and a point for the first
/// step; then the same for the search, which counts as one step.
template <Volume V>
std::uint64_t transform_count(const StageCounts& stages, const OverlapOptions& options) {
    const std::uint64_t tests = test_count(stages);
    if constexpr (std::same_as<V, Ball> || std::same_as<V, Aabb> || std::same_as<V, ExactAabb>) {
        return tests;
    } else if constexpr (std::same_as<V, Obb>) {
        return 4 * tests;
    } else if constexpr (std::same_as<V, Scb2>) {
        return 3 * tests - 2 * stages[static_cast<std::size_t>(Stage::ball_ball)];
    } else if constexpr (ConvexVolume<V>) {
        return 5 * tests - 2 * stages[static_cast<std::size_t>(Stage::center_line)];
    } else {
        std::uint64_t without_normal = stages[static_cast<std::size_t>(Stage::ball_ball)];
        if (options.test != OverlapTest::extents)
            without_normal += stages[static_cast<std::size_t>(Stage::slab_ball)];
        return 2 * tests - without_normal;
    }
}

/// Tests and divides pairs of nodes of two bodies, or of one body with itself.
template <DescentRule rule, Volume V, class Test>
class CollidePolicy {
  public:
    /// `joined`: empty for two bodies, else see SelfCollider.
    CollidePolicy(const Collider<V>& a, const Collider<V>& b, const Placement& placed,
                  const Test& test, const CollideOptions& options,
                  std::span<const std::uint32_t> joined, Collision& result)
        : a_(a),
          b_(b),
          placed_(placed),
          test_(test),
          options_(options),
          joined_(joined),
          result_(result),
          depths_(joined.empty() ? std::vector<std::uint16_t>()
                                 : node_depths(*a.hierarchy.topology)) {}

    std::optional<NodePair> next_root() {
        if (is_done()) return std::nullopt;
        if (joined_.empty()) {
            if (next_root_++ > 0) return std::nullopt;
            return NodePair{0, 0, 0, 0};
        }
        // Each node's left child against its right child: together they lead to each pair once.
        for (; next_root_ < depths_.size(); ++next_root_) {
            const int depth = depths_[next_root_];
            const bool below = options_.stop_level >= 0 && depth >= options_.stop_level;
            if (below || nodes_a_[next_root_].is_leaf()) continue;
            const std::uint32_t left = nodes_a_[next_root_++].left;
            result_.depth = std::max(result_.depth, 2 * (depth + 1));
            return NodePair{left, left + 1, depth + 1, depth + 1};
        }
        return std::nullopt;
    }

    Stage test(const NodePair& pair) const {
        const Stage stage = test_(volumes_a_[pair.a], volumes_b_[pair.b], placed_);
        ++result_.stages[static_cast<std::size_t>(stage)];
        return stage;
    }

    bool is_end(const NodePair& pair) const { return at_end_a(pair) && at_end_b(pair); }

    /// Tests the triangles of two leaves. Out of line, so that the loop over the volumes is small.
    template <class Report>
    [[gnu::noinline]] void end(const NodePair& pair, const Report& report) {
        if (options_.stop_level >= 0) return found({pair.a, pair.b});
        const std::uint32_t a = a_.hierarchy.topology->order[nodes_a_[pair.a].first],
                            b = b_.hierarchy.topology->order[nodes_b_[pair.b].first];
        if (!joined_.empty() && share_vertex(a_.mesh, joined_, a, b))
            return report({a, b}, false, true);
        ++result_.n_p;
        const bool hit = triangles_overlap(corners(a_.mesh, a),
                                           transform_corners(placed_.b_to_a, corners(b_.mesh, b)));
        report({a, b}, hit, false);
        if (hit) found(joined_.empty() || a < b ? IndexPair{a, b} : IndexPair{b, a});
    }

    std::array<NodePair, 2> divide(const NodePair& p) const {
        const int depth = p.depth_a + p.depth_b;
        result_.depth = std::max(result_.depth, depth + 1);
        if (at_end_b(p) ||
            (!at_end_a(p) && descends_into_a<rule>(volumes_a_[p.a], volumes_b_[p.b], depth))) {
            const std::uint32_t left = nodes_a_[p.a].left;
            return {
                {{left, p.b, p.depth_a + 1, p.depth_b}, {left + 1, p.b, p.depth_a + 1, p.depth_b}}};
        }
        const std::uint32_t left = nodes_b_[p.b].left;
        return {{{p.a, left, p.depth_a, p.depth_b + 1}, {p.a, left + 1, p.depth_a, p.depth_b + 1}}};
    }

    bool is_done() const { return !result_.complete; }

  private:
    void found(IndexPair pair) const {
        result_.pairs.push_back(pair);
        if (result_.pairs.size() >= options_.max_pairs) result_.complete = false;
    }
    bool at_end_a(const NodePair& pair) const {
        return nodes_a_[pair.a].is_leaf() || pair.depth_a == options_.stop_level;
    }
    bool at_end_b(const NodePair& pair) const {
        return nodes_b_[pair.b].is_leaf() || pair.depth_b == options_.stop_level;
    }

    const Collider<V>&a_, &b_;
    const Placement& placed_;
    const Test& test_;
    const CollideOptions& options_;
    const std::span<const std::uint32_t> joined_;
    Collision& result_;
    const std::vector<std::uint16_t> depths_;  ///< of the nodes, in a self query
    std::uint32_t next_root_ = 0;
    const TopologyNode* const nodes_a_ = a_.hierarchy.topology->nodes.data();
    const TopologyNode* const nodes_b_ = b_.hierarchy.topology->nodes.data();
    const V* const volumes_a_ = a_.hierarchy.volumes.data();
    const V* const volumes_b_ = b_.hierarchy.volumes.data();
};

/// Traverses with the test and the rule in `options`. Returns counts and sorted pairs. `joined`:
/// empty for two bodies, else see SelfCollider.
template <Volume V, class O>
Collision dual_traversal(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                         const CollideOptions& options, O& observer,
                         std::span<const std::uint32_t> joined = {}) {
    Collision result;
    const Placement placed = query_placement(a.hierarchy, b.hierarchy, b_to_a);
    with_overlap_test<V>(options.overlap, [&](const auto& test) {
        const auto run = [&]<DescentRule rule>() {
            CollidePolicy<rule, V, std::remove_cvref_t<decltype(test)>> policy(
                a, b, placed, test, options, joined, result);
            traverse(policy, observer);
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
