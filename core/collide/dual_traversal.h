#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"
#include "scb/collide.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// No observer; its calls compile away.
struct NoObserver {};

/// Whether O is an observer. Calls that do nothing still change how a compiler orders instructions,
/// so without an observer there are no calls.
template <class O>
inline constexpr bool observed = !std::same_as<O, NoObserver>;

/// Hands the tests of one query to an observer, as numbered steps. Throws std::length_error where a
/// number or a depth does not fit into a step.
template <class O>
class StepNumbers {
  public:
    explicit StepNumbers(O& observer) : observer_(observer) {}

    /// Returns the number of the step.
    std::uint32_t volume_test(IndexPair nodes, int depth_a, int depth_b, Stage stage,
                              std::uint32_t parent) {
        constexpr int deepest = std::numeric_limits<std::uint16_t>::max();
        if (depth_a > deepest || depth_b > deepest || next_ == no_step)
            throw std::length_error("a query too deep or too long to be observed");
        observer_.volume_test(Step{nodes, static_cast<std::uint16_t>(depth_a),
                                   static_cast<std::uint16_t>(depth_b), stage, parent});
        return next_++;
    }
    void item_test(const ItemStep& items) { observer_.item_test(items); }

  private:
    O& observer_;
    std::uint32_t next_ = 0;
};

/// Of no observer.
template <>
class StepNumbers<NoObserver> {
  public:
    explicit StepNumbers(NoObserver&) {}
};

/// An argument of the traversal. Without an observer it goes by value, which takes no instruction.
template <class O>
using StepsArgument = std::conditional_t<observed<O>, StepNumbers<O>&, StepNumbers<NoObserver>>;

/// The number of a step, where an observer receives steps.
template <class O>
using StepNumber = std::conditional_t<observed<O>, std::uint32_t, NoObserver>;

/// The area and the volume by which a node is chosen to be divided: its own, but for volumes that
/// have a quicker one.
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

/// Whether A's node is the one that is divided. `depth` is that of the pair: both nodes' depths
/// added.
template <DescentRule rule, Volume V>
bool descends_into_a(const V& a, const V& b, int depth) {
    if constexpr (rule == DescentRule::radius) return descent_size(a) >= descent_size(b);
    if constexpr (rule == DescentRule::area) return descent_area(a) >= descent_area(b);
    if constexpr (rule == DescentRule::volume) return descent_volume(a) >= descent_volume(b);
    return depth % 2 == 0;
}

/// N_u of equation 1: the points and directions of B's volumes that these tests transformed. A test
/// of slab cut balls transforms the center, and the normal where it gets that far; of balls the
/// center; of boxes the center and three axes, of those along the body's axes the center; of two
/// slabs the center and, after the balls, both normals; of convex volumes the center, and a
/// direction and a point for the first step or for as many as the search takes, counted as one.
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

/// The traversal, compiled for one volume type, overlap test, descent rule and observer.
template <DescentRule rule, Volume V, class Test, class O>
void traverse(const Collider<V>& a, const Collider<V>& b, const Placement& placed, const Test& test,
              const CollideOptions& options, O& observer, Collision& result) {
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
        [[no_unique_address]] StepNumber<O> step;
    };
    std::vector<Pending> pending;
    pending.reserve(256);

    const auto found = [&](std::uint32_t i, std::uint32_t j) {
        result.pairs.push_back({i, j});
        if (result.pairs.size() >= options.max_pairs) result.complete = false;
    };
    // A pair that overlaps is tested for triangles at once, or divided later. The steps are an
    // argument, since a capture would be stored even without an observer.
    const auto visit = [&](StepsArgument<O> steps, std::uint32_t i, std::uint32_t j, int depth_a,
                           int depth_b, StepNumber<O> parent) {
        const Stage stage = test(volumes_a[i], volumes_b[j], placed);
        ++result.stages[static_cast<std::size_t>(stage)];
        StepNumber<O> step{};
        if constexpr (observed<O>)
            step = steps.volume_test({i, j}, depth_a, depth_b, stage, parent);
        if (stage != Stage::overlapping) return;
        const bool at_end_a = nodes_a[i].is_leaf() || depth_a == options.stop_level;
        const bool at_end_b = nodes_b[j].is_leaf() || depth_b == options.stop_level;
        if (!at_end_a || !at_end_b) {
            pending.push_back({i, j, depth_a, depth_b, step});
            return;
        }
        if (options.stop_level >= 0) return found(i, j);
        const std::uint32_t triangle_a = topology_a.order[nodes_a[i].first];
        const std::uint32_t triangle_b = topology_b.order[nodes_b[j].first];
        ++result.n_p;
        const bool intersect =
            triangles_overlap(corners(a.mesh, triangle_a),
                              transform_corners(placed.b_to_a, corners(b.mesh, triangle_b)));
        if constexpr (observed<O>) steps.item_test({{triangle_a, triangle_b}, step, intersect});
        if (intersect) found(triangle_a, triangle_b);
    };

    StepNumbers<O> steps(observer);
    StepNumber<O> root{};
    if constexpr (observed<O>) root = no_step;
    visit(steps, 0, 0, 0, 0, root);
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
            visit(steps, left, p.b, p.depth_a + 1, p.depth_b, p.step);
            if (result.complete) visit(steps, left + 1, p.b, p.depth_a + 1, p.depth_b, p.step);
        } else {
            const std::uint32_t left = nodes_b[p.b].left;
            visit(steps, p.a, left, p.depth_a, p.depth_b + 1, p.step);
            if (result.complete) visit(steps, p.a, left + 1, p.depth_a, p.depth_b + 1, p.step);
        }
    }
}

/// The traversal with the test and the rule that the options name; its counts and sorted pairs.
template <Volume V, class O>
Collision dual_traversal(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                         const CollideOptions& options, O& observer) {
    Collision result;
    const Placement placed = query_placement(a.hierarchy, b.hierarchy, b_to_a);
    with_overlap_test<V>(options.overlap, [&](const auto& test) {
        const auto run = [&]<DescentRule rule>() {
            traverse<rule>(a, b, placed, test, options, observer, result);
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
