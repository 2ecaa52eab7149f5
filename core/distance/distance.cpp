#include "scb/distance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <compare>
#include <span>
#include <utility>

#include "core/base/enum_names.h"
#include "core/collide/dual_traversal.h"
#include "core/distance/volume_gap.h"
#include "core/traverse/keyed_traversal.h"

namespace scb {
namespace {

/// The key of a pair of nodes.
struct GapKey {
    double bound, order;

    friend auto operator<=>(const GapKey&, const GapKey&) = default;
};

/// What both kinds of queries have in common: the bound of two nodes, and their division.
template <Volume V>
class GapPolicy {
  public:
    using Key = GapKey;

    GapPolicy(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, DescentRule descent,
              StageCounts& stages)
        : a_(a),
          b_(b),
          placed_(query_placement(a.hierarchy, b.hierarchy, b_to_a)),
          descent_(descent),
          stages_(stages) {}

    std::optional<NodePair> next_root() {
        if (std::exchange(began_, true)) return std::nullopt;
        return NodePair{0, 0, 0, 0};
    }
    bool is_end(const NodePair& pair) const { return is_leaf_a(pair) && is_leaf_b(pair); }

    std::array<NodePair, 2> divide(const NodePair& p) const {
        if (is_leaf_b(p) || (!is_leaf_a(p) && descends(p))) {
            const std::uint32_t left = a_.hierarchy.topology->nodes[p.a].left;
            return {
                {{left, p.b, p.depth_a + 1, p.depth_b}, {left + 1, p.b, p.depth_a + 1, p.depth_b}}};
        }
        const std::uint32_t left = b_.hierarchy.topology->nodes[p.b].left;
        return {{{p.a, left, p.depth_a, p.depth_b + 1}, {p.a, left + 1, p.depth_a, p.depth_b + 1}}};
    }

  protected:
    /// `limit`: a pair with this bound or more ends here.
    KeyedTest<GapKey> test_below(const NodePair& pair, double limit) const {
        const VolumeGap gap =
            volume_gap(a_.hierarchy.volumes[pair.a], b_.hierarchy.volumes[pair.b], placed_);
        const bool is_near = gap.bound < limit;
        const Stage stage = is_near ? Stage::overlapping : gap.stage;
        ++stages_[static_cast<std::size_t>(stage)];
        return {stage, {gap.bound, gap.order}};
    }
    IndexPair triangles(const NodePair& pair) const {
        return {triangle(a_, pair.a), triangle(b_, pair.b)};
    }
    TriangleDistance distance_of(IndexPair pair) const {
        return triangle_distance(corners(a_.mesh, pair.a),
                                 transform_corners(placed_.b_to_a, corners(b_.mesh, pair.b)));
    }

  private:
    static std::uint32_t triangle(const Collider<V>& side, std::uint32_t leaf) {
        return side.hierarchy.topology->order[side.hierarchy.topology->nodes[leaf].first];
    }
    bool is_leaf_a(const NodePair& p) const { return a_.hierarchy.topology->nodes[p.a].is_leaf(); }
    bool is_leaf_b(const NodePair& p) const { return b_.hierarchy.topology->nodes[p.b].is_leaf(); }
    bool descends(const NodePair& p) const {
        const V &a = a_.hierarchy.volumes[p.a], &b = b_.hierarchy.volumes[p.b];
        const int depth = p.depth_a + p.depth_b;
        switch (descent_) {
            case DescentRule::radius:
                return descends_into_a<DescentRule::radius>(a, b, depth);
            case DescentRule::area:
                return descends_into_a<DescentRule::area>(a, b, depth);
            case DescentRule::volume:
                return descends_into_a<DescentRule::volume>(a, b, depth);
            case DescentRule::alternating:
                break;
        }
        return descends_into_a<DescentRule::alternating>(a, b, depth);
    }

    const Collider<V>&a_, &b_;
    Placement placed_;
    DescentRule descent_;
    StageCounts& stages_;
    bool began_ = false;
};

/// Looks for the smallest distance.
template <Volume V>
class DistancePolicy : public GapPolicy<V> {
  public:
    DistancePolicy(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                   const DistanceOptions& options, Distance& result)
        : GapPolicy<V>(a, b, b_to_a, options.descent, result.stages),
          options_(options),
          result_(result) {
        if (options.seed) measure(*options.seed);
    }

    KeyedTest<GapKey> test(const NodePair& pair) const { return this->test_below(pair, limit()); }
    bool is_open(const GapKey& key) const { return key.bound < limit(); }
    template <class Report>
    void end(const NodePair& pair, const Report& report) {
        const IndexPair items = this->triangles(pair);
        report(items, measure(items), false);
    }
    bool is_done() const {
        const double found = result_.found.distance;
        return found == 0 || (result_.triangles && found <= options_.enough);
    }

  private:
    /// Bounds are below distances, so that pairs with the same distance pass.
    double limit() const {
        return std::min(result_.found.distance / (1 + options_.relative_error), beyond_limit_);
    }
    /// Returns whether no pair before is nearer.
    bool measure(IndexPair pair) {
        ++result_.n_p;
        const TriangleDistance found = this->distance_of(pair);
        const double best = result_.found.distance;
        const bool is_nearer =
            found.distance < best ||
            (found.distance == best && result_.triangles && pair < *result_.triangles);
        if (!is_nearer || found.distance > options_.limit) return false;
        result_.found = found;
        result_.triangles = pair;
        return true;
    }

    const DistanceOptions& options_;
    const double beyond_limit_ = std::nextafter(options_.limit, HUGE_VAL);
    Distance& result_;
};

/// Finds all triangles within a distance.
template <Volume V>
class WithinPolicy : public GapPolicy<V> {
  public:
    WithinPolicy(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, double tolerance,
                 DescentRule descent, Collision& result)
        : GapPolicy<V>(a, b, b_to_a, descent, result.stages),
          tolerance_(tolerance),
          result_(result) {}

    KeyedTest<GapKey> test(const NodePair& pair) const { return this->test_below(pair, beyond_); }
    bool is_open(const GapKey&) const { return true; }
    template <class Report>
    void end(const NodePair& pair, const Report& report) {
        const IndexPair items = this->triangles(pair);
        ++result_.n_p;
        const bool is_near = this->distance_of(items).distance <= tolerance_;
        if (is_near) result_.pairs.push_back(items);
        report(items, is_near, false);
    }
    bool is_done() const { return false; }

  private:
    const double tolerance_, beyond_ = std::nextafter(tolerance_, HUGE_VAL);
    Collision& result_;
};

template <Volume V, class O>
Distance observed_distance(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                           const DistanceOptions& options, O& observer) {
    assert(options.relative_error >= 0 && "see DistanceOptions");
    Distance result;
    DistancePolicy<V> policy(a, b, b_to_a, options, result);
    if (policy.is_done()) return result;
    if (options.order == DistanceOrder::depth_first) {
        KeyedDepthFirst<KeyedPair<O, GapKey>> pending;
        traverse_by_key(policy, observer, pending);
    } else {
        const bool is_hybrid = options.order == DistanceOrder::hybrid;
        LeastFirst<KeyedPair<O, GapKey>> pending(
            is_hybrid ? options.heap : std::numeric_limits<std::size_t>::max());
        traverse_by_key(policy, observer, pending);
    }
    result.n_v = test_count(result.stages);
    result.n_u = result.n_v * transforms_per_gap<V>();
    return result;
}

template <Volume V, class O>
Collision observed_within(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                          double tolerance, DescentRule descent, O& observer) {
    assert(tolerance >= 0 && "a distance");
    Collision result;
    WithinPolicy<V> policy(a, b, b_to_a, tolerance, descent, result);
    KeyedDepthFirst<KeyedPair<O, GapKey>> pending;
    traverse_by_key(policy, observer, pending);
    result.n_v = test_count(result.stages);
    result.n_u = result.n_v * transforms_per_gap<V>();
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

/// Pairs of leaves wait before their triangles are measured, so the tests of triangles come in
/// another order than their steps.
void sort_by_step(std::vector<ItemStep>& items, std::size_t first) {
    std::stable_sort(items.begin() + static_cast<std::ptrdiff_t>(first), items.end(),
                     [](const ItemStep& x, const ItemStep& y) { return x.step < y.step; });
}

constexpr EnumNames<DistanceOrder, 3> order_names = {"nearest", "depth-first", "hybrid"};

}  // namespace

template <Volume V>
Distance distance(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const DistanceOptions& options) {
    NoObserver none;
    return observed_distance(a, b, b_to_a, options, none);
}

template <Volume V>
Distance distance(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const DistanceOptions& options, StepRecorder& recorder) {
    const std::size_t first = recorder.steps.items.size();
    const Distance result = observed_distance(a, b, b_to_a, options, recorder);
    sort_by_step(recorder.steps.items, first);
    return result;
}

template <Volume V>
Collision within(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, double tolerance,
                 DescentRule descent) {
    NoObserver none;
    return observed_within(a, b, b_to_a, tolerance, descent, none);
}

template <Volume V>
Collision within(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a, double tolerance,
                 DescentRule descent, StepRecorder& recorder) {
    const std::size_t first = recorder.steps.items.size();
    Collision result = observed_within(a, b, b_to_a, tolerance, descent, recorder);
    sort_by_step(recorder.steps.items, first);
    return result;
}

std::string_view distance_order_name(DistanceOrder order) { return order_names[order]; }
std::optional<DistanceOrder> distance_order_of(std::string_view name) {
    return order_names.find(name);
}

#define SCB_INSTANTIATE(V)                                                                 \
    template Distance distance(const Collider<V>&, const Collider<V>&, const Pose&,        \
                               const DistanceOptions&);                                    \
    template Distance distance(const Collider<V>&, const Collider<V>&, const Pose&,        \
                               const DistanceOptions&, StepRecorder&);                     \
    template Collision within(const Collider<V>&, const Collider<V>&, const Pose&, double, \
                              DescentRule);                                                \
    template Collision within(const Collider<V>&, const Collider<V>&, const Pose&, double, \
                              DescentRule, StepRecorder&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
