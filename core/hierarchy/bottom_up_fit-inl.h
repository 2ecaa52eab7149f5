// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_BOTTOM_UP_FIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_BOTTOM_UP_FIT_INL_H_
#undef SCB_CORE_BOTTOM_UP_FIT_INL_H_
#else
#define SCB_CORE_BOTTOM_UP_FIT_INL_H_
#endif

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/fit/dop26-inl.h"
#include "core/fit/fit_aabb-inl.h"
#include "core/fit/fit_convex-inl.h"
#include "core/fit/fit_obb-inl.h"
#include "core/fit/fit_scb2-inl.h"
#include "core/hierarchy/fit_target.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/topology.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The indices of a DOP's pairs among points, by their ids; each id must be among `ids`.
HWY_INLINE void find_pairs(const Dop26& dop, const double* ids, std::size_t count,
                           ExtremalPairs& pairs) {
    const hn::FixedTag<std::int32_t, double_lanes> integers;
    for (std::size_t i = 0; i < Dop26::padded; i += double_lanes) {
        const Doubles upper_id = Doubles::load(&dop.upper_id[i]),
                      lower_id = Doubles::load(&dop.lower_id[i]);
        Doubles upper = Doubles::all(0), lower = upper;
        for (std::size_t k = 1; k < count; ++k) {
            const Doubles id = Doubles::all(ids[k]), index = Doubles::all(static_cast<double>(k));
            upper = select(upper_id == id, index, upper);
            lower = select(lower_id == id, index, lower);
        }
        hn::StoreU(hn::DemoteTo(integers, upper.v), integers, &pairs.upper[i]);
        hn::StoreU(hn::DemoteTo(integers, lower.v), integers, &pairs.lower[i]);
    }
}

/// Fits the volumes of a subtree, children before their parents. The data of a fitted subtree that
/// its parent needs are on a stack. A second stack has the ids of the points that the subtree
/// shares with triangles left of it. Unwanted nodes are merged too.
template <class V>
class BottomUpFit {
  public:
    BottomUpFit(const Topology& topology, const LeafOrder& points, const FitOptions& options,
                int threads, const FitTarget<V>& target)
        : topology_(topology),
          points_(points),
          options_(options),
          threads_(threads),
          target_(target) {}

    void run(std::uint32_t root, int depth = 0) {
        // Above some thousand triangles, the two halves are fitted in parallel.
        constexpr std::uint32_t divided_from = 4096;
        const TopologyNode& node = topology_.nodes[root];
        if (threads_ == 1 || node.count < divided_from) {
            in_turn(root, depth);
            return;
        }
        BottomUpFit right(topology_, points_, options_, threads_, target_);
        parallel_invoke(
            threads_, [&] { run(node.left, depth + 1); },
            [&] { right.run(node.left + 1, depth + 1); });
        append(right);
        merge_top_two();
        fit_if_wanted(root, depth);
    }

    const FitCounts& counts() const { return counts_; }

  private:
    static constexpr bool needs_dop = !std::is_same_v<V, Obb>;
    static constexpr bool needs_moments = std::is_same_v<V, Obb> || ConvexVolume<V>;

    struct Subtree {
        Dop26 dop;
        SurfaceMoments moments;
        std::uint32_t own_first;     // its own points: ids from here to the next subtree's
        std::uint32_t shared_count;  // its shared points: ids below own_first
    };

    void in_turn(std::uint32_t root, int root_depth) {
        // A node is visited twice: before its children, and after them.
        struct Visit {
            std::uint32_t index;
            int depth;
            bool children_done;
        };
        std::vector<Visit> open = {{root, root_depth, false}};
        while (!open.empty()) {
            const auto [index, depth, children_done] = open.back();
            open.pop_back();
            const TopologyNode& node = topology_.nodes[index];
            if (node.is_leaf()) {
                push_leaf(node);
            } else if (!children_done) {
                open.push_back({index, depth, true});
                open.push_back({node.left + 1, depth + 1, false});
                open.push_back({node.left, depth + 1, false});
                continue;
            } else {
                merge_top_two();
            }
            fit_if_wanted(index, depth);
        }
    }

    // Fits the node on top of the stack.
    void fit_if_wanted(std::uint32_t index, int depth) {
        const std::uint32_t place = target_.place.empty() ? index : target_.place[index];
        if (place == no_place || depth > target_.deepest) return;
        fit_top(topology_.nodes[index], target_.volumes[place]);
    }

    void append(BottomUpFit& right) {
        stack_.push_back(right.stack_.back());
        shared_.insert(shared_.end(), right.shared_.begin(), right.shared_.end());
        counts_.add(right.counts_);
    }

    void push_leaf(const TopologyNode& node) {
        const auto& corners = points_.corners[node.first];
        const PointsView all = points_.points.view();
        Subtree& leaf = stack_.emplace_back();
        leaf.own_first = points_.own_first[node.first];
        leaf.shared_count = 0;
        if constexpr (needs_dop)
            for (std::size_t i = 0; i < Dop26::padded; i += double_lanes) {
                const auto corner = [&](std::size_t k) HWY_ATTR {
                    return DopLanes::of_point(Doubles3::all(all[corners[k]]), corners[k], i);
                };
                merge(merge(corner(0), corner(1)), corner(2)).store(leaf.dop, i);
            }
        if constexpr (needs_moments)
            leaf.moments = triangle_moments(all[corners[0]], all[corners[1]], all[corners[2]]);
        for (const std::uint32_t id : corners)
            if (id < leaf.own_first) add_shared(leaf, id);
    }

    // Keeps the ids in ascending order, each once.
    void add_shared(Subtree& leaf, std::uint32_t id) {
        const auto begin = shared_.end() - leaf.shared_count;
        const auto at = std::lower_bound(begin, shared_.end(), id);
        if (at != shared_.end() && *at == id) return;
        shared_.insert(at, id);
        ++leaf.shared_count;
    }

    void merge_top_two() {
        const Subtree& right = stack_.back();
        Subtree& left = stack_[stack_.size() - 2];
        if constexpr (needs_dop) merge_into(left.dop, right.dop);
        if constexpr (needs_moments) left.moments = merge(left.moments, right.moments);
        // Shared points of the right child that are the left child's own become their parent's own.
        const auto right_begin = shared_.end() - right.shared_count;
        const auto left_begin = right_begin - left.shared_count;
        const auto right_end = std::lower_bound(right_begin, shared_.end(), left.own_first);
        merged_.clear();
        std::set_union(left_begin, right_begin, right_begin, right_end,
                       std::back_inserter(merged_));
        shared_.erase(std::copy(merged_.begin(), merged_.end(), left_begin), shared_.end());
        left.shared_count = static_cast<std::uint32_t>(merged_.size());
        stack_.pop_back();
    }

    void fit_top(const TopologyNode& node, V& volume) {
        const Subtree& top = stack_.back();
        const PointsView all = points_.points.view();
        const std::span<const std::uint32_t> shared(shared_.end() - top.shared_count,
                                                    shared_.end());
        const PointsView own =
            all.sub(top.own_first, points_.own_first[node.first + node.count] - top.own_first);
        FitInput input{{}, &few_, &pairs_, &top.dop, needs_moments ? &top.moments : nullptr};
        if (shared.size() + own.size <= FewPoints::capacity) {
            gather_few(shared, own, top.own_first);
            input.parts[0] = few_.view();
            if constexpr (needs_dop) find_pairs(top.dop, ids_.data(), few_.count, pairs_);
        } else {
            gathered_.clear();
            for (const std::uint32_t id : shared) gathered_.push_back(all[id]);
            input.parts = {gathered_.view(), own};
            if constexpr (needs_dop) extremal_points(top.dop, all, few_, pairs_);
        }
        fit(volume, input, options_, counts_);
    }

    void gather_few(std::span<const std::uint32_t> shared, const PointsView& own,
                    std::uint32_t own_first) {
        const PointsView all = points_.points.view();
        few_.count = 0;
        for (const std::uint32_t id : shared) {
            ids_[few_.count] = id;
            few_.add(all.x[id], all.y[id], all.z[id]);
        }
        for (std::size_t i = 0; i < own.size; ++i) {
            ids_[few_.count] = static_cast<double>(own_first + i);
            few_.add(own.x[i], own.y[i], own.z[i]);
        }
        few_.pad();
    }

    const Topology& topology_;
    const LeafOrder& points_;
    const FitOptions& options_;
    const int threads_;
    const FitTarget<V> target_;
    FitCounts counts_;
    std::vector<Subtree> stack_;
    std::vector<std::uint32_t> shared_, merged_;
    PointArrays gathered_;
    FewPoints few_;
    std::array<double, FewPoints::capacity> ids_;
    ExtremalPairs pairs_;
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
