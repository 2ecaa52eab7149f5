// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_PACKED_TRAVERSAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_PACKED_TRAVERSAL_INL_H_
#undef SCB_CORE_PACKED_TRAVERSAL_INL_H_
#else
#define SCB_CORE_PACKED_TRAVERSAL_INL_H_
#endif

#include <bit>
#include <cassert>

#include "core/base/lane_parts-inl.h"
#include "core/packed/packed_query.h"
#include "core/packed/packed_steps.h"
#include "core/packed/two_slab_kernel-inl.h"
#include "core/packed/volume_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The traversal of two packed hierarchies, compiled for one layout. Pairs wait in one list for
/// each combination of inner nodes and leaves. A batch of one list at a time is divided, with its
/// cache lines prefetched. To find a first pair of triangles, a traversal begins with the nearest
/// pair of children at each pair of nodes, and defers the others. `Steps`: PackedSteps&, which
/// receives every test, or NoObserver.
template <class Codec, class Steps = NoObserver>
class PackedTraversal {
  public:
    PackedTraversal(const PackedQuery<Codec>& query, PackedLists& lists, PackedFindings& found,
                    Steps steps = {})
        : a_(*query.a),
          b_(*query.b),
          placed_(*query.placed),
          skin_(query.skin),
          kept_size_(query.kept_size),
          lists_(lists),
          found_(found),
          steps_(steps) {}

    /// Runs until no pair is left to divide, or many pairs of leaves wait.
    void run(const PackedPace& pace = {}) {
        std::size_t nearest = pace.nearest;
        while (lists_.leaf_leaf.size() < pace.leaves) {
            nearest_first_ = nearest > 0;
            if (nearest_first_) --nearest;
            const std::size_t most = nearest_first_ ? 1 : pace.nodes;
            if (!lists_.inner_leaf.empty())
                divide(most, &PackedLists::inner_leaf,
                       [&](PackedRef i, PackedRef j) HWY_ATTR { inner_leaf(i, j); });
            else if (!lists_.leaf_inner.empty())
                divide(most, &PackedLists::leaf_inner,
                       [&](PackedRef i, PackedRef j) HWY_ATTR { leaf_inner(i, j); });
            else if (!lists_.inner_inner.empty())
                divide(most, &PackedLists::inner_inner,
                       [&](PackedRef i, PackedRef j) HWY_ATTR { inner_inner(i, j); });
            else if (!lists_.deferred.empty())
                divide(most, &PackedLists::deferred,
                       [&](PackedRef i, PackedRef j) HWY_ATTR { deferred(i, j); });
            else
                return;
        }
    }

    /// Divides every pair of the lists once.
    void run_once() {
        assert(lists_.deferred.empty() && "only queries for a first pair defer");
        // Pairs that are added meanwhile are appended to the lists.
        const PackedLists before = lists_;
        lists_.inner_inner.clear();
        lists_.inner_leaf.clear();
        lists_.leaf_inner.clear();
        const auto each = [&](RefPairs PackedLists::*which, auto divide_pair) HWY_ATTR {
            const RefPairs& list = before.*which;
            for (std::size_t i = 0; i < list.size(); ++i) {
                const PackedRef a{list.a_begin()[i]}, b{list.b_begin()[i]};
                if (skin_ > 0 && is_kept(a, b)) {
                    (found_.kept.*which).add(a.bits, b.bits);
                    continue;
                }
                lists_.reserve(W * W + 16);
                divide_pair(a, b);
            }
        };
        each(&PackedLists::inner_leaf,
             [&](PackedRef i, PackedRef j) HWY_ATTR { inner_leaf(i, j); });
        each(&PackedLists::leaf_inner,
             [&](PackedRef i, PackedRef j) HWY_ATTR { leaf_inner(i, j); });
        each(&PackedLists::inner_inner,
             [&](PackedRef i, PackedRef j) HWY_ATTR { inner_inner(i, j); });
    }

  private:
    using Node = PackedNode<Codec>;
    using Volume = typename Codec::Decoded;
    static constexpr int W = child_lanes<Codec::width>;
    using Part = ChildLanes<Codec>;
    static constexpr int n = Part::n;
    static constexpr std::size_t ahead = 4;
    /// The skin adds to the lengths, and is rounded as often as they are.
    HWY_INLINE float margin(const Offset& o) const {
        const float rounded = Part::distance_bound * float_unit * (o.length + skin_);
        return rounded + placed_.double_error + skin_;
    }

    HWY_INLINE bool is_kept(PackedRef i, PackedRef j) const {
        return radius(a_, i) + radius(b_, j) <= kept_size_;
    }
    static HWY_INLINE float radius(const PackedHierarchy<Codec>& side, PackedRef ref) {
        return ref.is_leaf() ? side.leaf(ref).radius() : side.nodes[ref.index()].own.r;
    }
    /// Moves the pairs of a batch that are small enough to `kept`; returns the number of the
    /// others.
    std::size_t keep_small(std::uint32_t* a, std::uint32_t* b, std::size_t count, RefPairs& kept) {
        std::size_t left = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (is_kept({a[i]}, {b[i]})) {
                kept.add(a[i], b[i]);
                continue;
            }
            a[left] = a[i];
            b[left++] = b[i];
        }
        return left;
    }

    template <class Divide>
    HWY_INLINE void divide(std::size_t most, RefPairs PackedLists::*which, Divide each) {
        std::uint32_t a[PackedPace::most_nodes], b[PackedPace::most_nodes];
        std::size_t count = (lists_.*which).take(a, b, most);
        if (skin_ > 0) count = keep_small(a, b, count, found_.kept.*which);
        lists_.reserve(count * (W * W + 16));
        for (std::size_t i = 0; i < count && i < ahead; ++i) prefetch_pair({a[i]}, {b[i]});
        for (std::size_t i = 0; i < count; ++i) {
            if (i + ahead < count) prefetch_pair({a[i + ahead]}, {b[i + ahead]});
            each({a[i]}, {b[i]});
        }
    }
    HWY_INLINE void prefetch_pair(PackedRef i, PackedRef j) const {
        fetch(a_, i);
        fetch(b_, j);
    }
    static HWY_INLINE void fetch(const PackedHierarchy<Codec>& side, PackedRef ref) {
        if (ref.is_leaf())
            prefetch_leaf(side.leaves.data() + ref.index());
        else
            prefetch(reinterpret_cast<const char*>(&side.nodes[ref.index()]), sizeof(Node));
    }

    /// Adds chosen children of A, each with one node of B, to the lists.
    HWY_INLINE void put_a(const Node& a, std::uint32_t bits, PackedRef b) {
        RefPairs& inner = b.is_leaf() ? lists_.inner_leaf : lists_.inner_inner;
        RefPairs& leaf = b.is_leaf() ? lists_.leaf_leaf : lists_.leaf_inner;
        put(inner.a_end(), inner.b_end(), a.child, bits & ~a.leaf_bits, b.bits, inner);
        put(leaf.a_end(), leaf.b_end(), a.child, bits & a.leaf_bits, b.bits, leaf);
    }
    /// The same. While the traversal goes to the nearest pair first, the nearest child is added
    /// last: the last pair is divided next. `apart`: see separation.
    HWY_INLINE void put_a(const Node& a, std::uint32_t bits, PackedRef b, const float* apart) {
        if (nearest_first_ && bits != 0) {
            const std::uint32_t nearest = least(apart, bits);
            put_a(a, bits & ~nearest, b);
            bits = nearest;
        }
        put_a(a, bits, b);
    }
    HWY_INLINE void put_b(PackedRef a, const Node& b, std::uint32_t bits) {
        RefPairs& inner = a.is_leaf() ? lists_.leaf_inner : lists_.inner_inner;
        RefPairs& leaf = a.is_leaf() ? lists_.leaf_leaf : lists_.inner_leaf;
        put(inner.b_end(), inner.a_end(), b.child, bits & ~b.leaf_bits, a.bits, inner);
        put(leaf.b_end(), leaf.a_end(), b.child, bits & b.leaf_bits, a.bits, leaf);
    }
    static HWY_INLINE void put(std::uint32_t* ones, std::uint32_t* others,
                               const std::uint32_t* children, std::uint32_t bits,
                               std::uint32_t other, RefPairs& list) {
        store_chosen<W>(children, bits, ones);
        for (int k = 0; k < W; ++k) others[k] = other;
        list.grow(static_cast<std::size_t>(std::popcount(bits)));
    }

    /// Reports the tests of the children of A with one node of B. `bits`: the children that
    /// overlap.
    HWY_INLINE void report_a(const Node& a, std::uint32_t bits, PackedRef b, RefPair parent) {
        if constexpr (observed<Steps>)
            for (std::uint32_t k = 0; k < a.count; ++k)
                steps_.test({{a.child[k]}, b}, (bits >> k & 1) != 0, parent);
    }
    HWY_INLINE void report_b(PackedRef a, const Node& b, std::uint32_t bits, RefPair parent) {
        if constexpr (observed<Steps>)
            for (std::uint32_t k = 0; k < b.count; ++k)
                steps_.test({a, {b.child[k]}}, (bits >> k & 1) != 0, parent);
    }

    static HWY_INLINE Volume centered(Volume volume) {
        volume.c[0] = volume.c[1] = volume.c[2] = 0;
        return volume;
    }
    HWY_INLINE Part children_of_b(const Node& b, int first, const Offset& o) const {
        return placed(load_children(b.volumes, first), placed_, Lanes3<n>::all(o.t));
    }

    /// Least for the balls that overlap most: the squared distance of their centers minus the
    /// squared sum of their radii.
    static HWY_INLINE Lanes<n> separation(const Part& a, const Part& b) {
        const Lanes3<n> c = b.c - a.c;
        const Lanes<n> sum = a.r + b.r;
        return dot(c, c) - sum * sum;
    }
    /// The bit of the least of the values that `bits` chooses; the first of equal ones.
    static HWY_INLINE std::uint32_t least(const float* values, std::uint32_t bits) {
        int best = std::countr_zero(bits);
        for (std::uint32_t left = bits & (bits - 1); left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            if (values[k] < values[best]) best = k;
        }
        return 1u << best;
    }

    HWY_INLINE void inner_inner(PackedRef i, PackedRef j) {
        const Node &a = a_.nodes[i.index()], &b = b_.nodes[j.index()];
        const Offset o = offset(placed_, a.own.c, a.reach, b.own.c, b.reach);
        const Lanes<n> wide = Lanes<n>::all(margin(o));
        const Part own = Part::all(centered(a.own));
        found_.n_v += b.count;
        std::uint32_t left = 0;
        float rows[Part::rows][W];  // the children of B in A's frame
        float apart[W];
        for (int first = 0; first < W; first += n) {
            const Part of_b = children_of_b(b, first, o);
            left |= overlap(own, of_b, wide).bits() << first;
            of_b.put(rows, first);
            if (nearest_first_) separation(own, of_b).store(apart + first);
        }
        left &= low_bits(b.count);
        report_b(i, b, left, {i, j});
        if (left == 0) return;
        if (nearest_first_) {
            const std::uint32_t nearest = least(apart, left);
            RefPairs& others = lists_.deferred;
            others.reserve(W + 16);
            put(others.b_end(), others.a_end(), b.child, left & ~nearest, i.bits, others);
            left = nearest;
        }
        const auto of_a = lane_parts<W / n>([&a](std::size_t part) HWY_ATTR {
            return load_children(a.volumes, static_cast<int>(part) * n);
        });
        for (; left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            const Part one = Part::column(rows, k);
            found_.n_v += a.count;
            std::uint32_t bits = 0;
            for (std::size_t part = 0; part < of_a.size(); ++part) {
                const std::size_t first = part * std::size_t{n};
                bits |= overlap(of_a[part], one, wide).bits() << first;
                if (nearest_first_) separation(of_a[part], one).store(apart + first);
            }
            report_a(a, bits, {b.child[k]}, {i, {b.child[k]}});
            put_a(a, bits & low_bits(a.count), {b.child[k]}, apart);
        }
    }

    HWY_INLINE void inner_leaf(PackedRef i, PackedRef j) {
        divide_a(i, j, b_.leaf(j).template own<Volume>());
    }

    /// B's node has been divided already.
    HWY_INLINE void deferred(PackedRef i, PackedRef j) {
        divide_a(i, j, j.is_leaf() ? b_.leaf(j).template own<Volume>() : b_.nodes[j.index()].own);
    }

    HWY_INLINE void divide_a(PackedRef i, PackedRef j, const Volume& b) {
        const Node& a = a_.nodes[i.index()];
        const Offset o = offset(placed_, a.own.c, a.reach, b.c, b.r);
        const Lanes<n> wide = Lanes<n>::all(margin(o));
        const Part of_b = placed(Part::all(centered(b)), placed_, Lanes3<n>::all(o.t));
        found_.n_v += a.count;
        std::uint32_t bits = 0;
        float apart[W];
        for (int first = 0; first < W; first += n) {
            const Part of_a = load_children(a.volumes, first);
            bits |= overlap(of_a, of_b, wide).bits() << first;
            if (nearest_first_) separation(of_a, of_b).store(apart + first);
        }
        report_a(a, bits, j, {i, j});
        put_a(a, bits & low_bits(a.count), j, apart);
    }

    HWY_INLINE void leaf_inner(PackedRef i, PackedRef j) {
        const Node& b = b_.nodes[j.index()];
        const Volume a = a_.leaf(i).template own<Volume>();
        const Offset o = offset(placed_, a.c, a.r, b.own.c, b.reach);
        const Lanes<n> wide = Lanes<n>::all(margin(o));
        const Part own = Part::all(centered(a));
        found_.n_v += b.count;
        std::uint32_t bits = 0;
        for (int first = 0; first < W; first += n)
            bits |= overlap(own, children_of_b(b, first, o), wide).bits() << first;
        report_b(i, b, bits, {i, j});
        put_b(i, b, bits & low_bits(b.count));
    }

    const PackedHierarchy<Codec>&a_, &b_;
    const FloatPlacement placed_;
    const float skin_, kept_size_;
    PackedLists& lists_;
    PackedFindings& found_;
    [[no_unique_address]] Steps steps_;
    bool nearest_first_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
