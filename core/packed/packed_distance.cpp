#include "scb/packed_distance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <tuple>

#include "core/packed/each_codec.h"
#include "core/packed/grown_slab.h"
#include "core/packed/near_search.h"
#include "core/packed/query_sides.h"
#include "core/packed/shared_corners.h"

namespace scb {
namespace {

/// A query, independent of the types of its hierarchies.
struct NearQuery {
    AnyPackedQuery nodes;
    LeafQuery leaves;
    const Mesh &a, &b;
    const Pose& b_to_a;
    SimdLevel level;
    std::size_t width;  ///< the most children of a node

    TriangleDistance distance_of(IndexPair pair) const {
        return triangle_distance(corners(a, pair.a), transform_corners(b_to_a, corners(b, pair.b)));
    }
};

/// Finds the least distance among pairs that have bounds. A pair whose lower bound is above the
/// least upper bound is not the nearest. Of the others, distances are computed at the end, when
/// few are left.
class LeastDistance {
  public:
    LeastDistance(const NearQuery& query, const DistanceOptions& options, NearSearch& search,
                  PackedDistance& result)
        : query_(query), options_(options), search_(search), result_(result) {
        if (options.seed) measure(*options.seed);
        update();
        search.take = [this](IndexPair pair, float least, float most) { take(pair, least, most); };
    }

    /// Computes the distances of the pairs that wait.
    void finish() {
        if (search_.is_done) return;
        drop_far();
        if (waiting_.empty()) return;
        // The nearest pair first: others often share its closest corners, and so its distance.
        const auto less = [](const Waiting& x, const Waiting& y) { return x.least < y.least; };
        std::iter_swap(waiting_.begin(), std::ranges::min_element(waiting_, less));
        measure(waiting_.front().pair);
        for (auto next = waiting_.begin() + 1; next != waiting_.end();) {
            IndexPair pairs[at_once];
            std::size_t count = 0;
            for (; count < at_once && next != waiting_.end(); ++next)
                if (static_cast<double>(next->least) <= limit() && !has_least_corners(next->pair))
                    pairs[count++] = next->pair;
            measure_apart({pairs, count});
        }
    }

  private:
    /// Distances that are computed at once, at most.
    static constexpr std::size_t at_once = 8;

    struct Waiting {
        float least;
        IndexPair pair;
    };

    void take(IndexPair pair, float least, float most) {
        // Triangles that may intersect, or be as near as the query asks, may end it.
        if (!(least > 0) || static_cast<double>(least) <= options_.enough) {
            measure(pair);
        } else {
            most_ = std::min(most_, static_cast<double>(most));
            waiting_.push_back({least, pair});
            if (waiting_.size() >= crowded_) drop_far();
        }
        update();
    }
    void drop_far() {
        std::erase_if(waiting_, [this](const Waiting& pair) {
            return static_cast<double>(pair.least) > limit();
        });
        crowded_ = std::max(crowded_, 2 * waiting_.size());
    }
    double limit() const { return std::min(most_, options_.limit); }
    void update() {
        search_.limit =
            float_above(std::min(most_ / (1 + options_.relative_error), options_.limit));
    }

    /// Whether a pair is nearer than all before; of several pairs the lowest.
    bool improves(double distance, IndexPair pair) const {
        const double best = result_.found.distance;
        return distance <= options_.limit &&
               (distance < best ||
                (distance == best && result_.triangles && pair < *result_.triangles));
    }
    void keep(const TriangleDistance& found, IndexPair pair) {
        result_.found = found;
        result_.triangles = pair;
        most_ = std::min(most_, found.distance);
    }
    void measure(IndexPair pair) {
        ++result_.n_p;
        const TriangleDistance found = query_.distance_of(pair);
        if (!improves(found.distance, pair)) return;
        keep(found, pair);
        search_.is_done = found.distance == 0 || found.distance <= options_.enough;
    }
    /// Computes the distances of pairs that do not intersect in lanes, and the points of the
    /// nearest.
    void measure_apart(std::span<const IndexPair> pairs) {
        std::array<double, at_once> distances;
        distances_apart(query_.a, query_.b, query_.b_to_a, query_.level, pairs, distances.data());
        result_.n_p += pairs.size();
        std::size_t best = pairs.size();
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (improves(distances[k], pairs[k]) &&
                (best == pairs.size() ||
                 std::tie(distances[k], pairs[k]) < std::tie(distances[best], pairs[best])))
                best = k;
        if (best < pairs.size()) keep(query_.distance_of(pairs[best]), pairs[best]);
    }
    /// Whether the distance of a pair is known: of the corners that are nearest so far, which fans
    /// of triangles share.
    bool has_least_corners(IndexPair pair) {
        if (!result_.triangles ||
            !is_distance_of_corners(corners(query_.a, pair.a),
                                    transform_corners(query_.b_to_a, corners(query_.b, pair.b)),
                                    result_.found))
            return false;
        if (improves(result_.found.distance, pair)) result_.triangles = pair;
        return true;
    }

    const NearQuery& query_;
    const DistanceOptions& options_;
    NearSearch& search_;
    PackedDistance& result_;
    double most_ = HUGE_VAL;  ///< an upper bound of the least distance
    std::vector<Waiting> waiting_;
    std::size_t crowded_ = 64;
};

/// The size of the heap that makes this order. A division adds up to `width` pairs, not two, so a
/// heap of the same depth is as many times larger.
std::size_t heap_of(const DistanceOptions& options, std::size_t width) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    if (options.order == DistanceOrder::depth_first) return 0;
    if (options.order == DistanceOrder::nearest) return most;
    return std::min(options.heap, most / width) * width / 2;
}

PackedDistance least_distance(const NearQuery& query, const DistanceOptions& options) {
    assert(options.relative_error >= 0 && "see DistanceOptions");
    PackedDistance result;
    NearSearch search;
    LeastDistance least(query, options, search, result);
    find_near(query.nodes, query.leaves, query.level, heap_of(options, query.width), search);
    least.finish();
    result.n_v = search.n_v;
    result.n_bounded = search.n_bounded;
    return result;
}

PackedWithin all_within(const NearQuery& query, double tolerance) {
    assert(tolerance >= 0 && "a distance");
    PackedWithin result;
    NearSearch search;
    search.limit = float_above(tolerance);
    search.take = [&](IndexPair pair, float, float most) {
        if (!(static_cast<double>(most) <= tolerance)) {
            ++result.n_p;
            if (query.distance_of(pair).distance > tolerance) return;
        }
        result.pairs.push_back(pair);
    };
    find_near(query.nodes, query.leaves, query.level, 0, search);
    result.n_v = search.n_v;
    result.n_bounded = search.n_bounded;
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

/// `placed`: see placement_of.
template <class Codec>
NearQuery near_query(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                     const Placement& placed, SimdLevel level) {
    return {PackedQuery<Codec>{&a.hierarchy, &b.hierarchy, &placed},
            {leaves_of(a), leaves_of(b), &placed},
            a.mesh,
            b.mesh,
            placed.b_to_a,
            level,
            Codec::width};
}

}  // namespace

template <class Codec>
PackedDistance distance_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const DistanceOptions& options,
                               SimdLevel level) {
    const Placement placed = placement_of(a, b, b_to_a);
    return least_distance(near_query(a, b, placed, level), options);
}

template <class Codec>
PackedWithin within_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                           const Pose& b_to_a, double tolerance, SimdLevel level) {
    const Placement placed = placement_of(a, b, b_to_a);
    return all_within(near_query(a, b, placed, level), tolerance);
}

#define SCB_DISTANCE(...)                                                                        \
    template PackedDistance distance_packed(const PackedCollider<__VA_ARGS__>&,                  \
                                            const PackedCollider<__VA_ARGS__>&, const Pose&,     \
                                            const DistanceOptions&, SimdLevel);                  \
    template PackedWithin within_packed(const PackedCollider<__VA_ARGS__>&,                      \
                                        const PackedCollider<__VA_ARGS__>&, const Pose&, double, \
                                        SimdLevel);
SCB_FOR_EACH_CODEC(SCB_DISTANCE)
#undef SCB_DISTANCE

}  // namespace scb
