// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_GAP_TRAVERSAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_GAP_TRAVERSAL_INL_H_
#undef SCB_CORE_GAP_TRAVERSAL_INL_H_
#else
#define SCB_CORE_GAP_TRAVERSAL_INL_H_
#endif

#include <bit>
#include <cstdint>
#include <utility>

#include "core/packed/gap_kernel-inl.h"
#include "core/packed/near_search.h"
#include "core/packed/near_triangles-inl.h"
#include "core/traverse/keyed_traversal.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// A pair that waits for its division.
struct NearPair {
    std::uint64_t key_and_a;  ///< the bits of the key, see gap_key, and of A's node
    PackedRef b;

    NearPair() = default;
    NearPair(float key, PackedRef a, PackedRef other)
        : key_and_a(std::uint64_t{ordered(key)} << 32 | a.bits), b(other) {}

    float key() const {
        const auto bits = static_cast<std::uint32_t>(key_and_a >> 32);
        return std::bit_cast<float>(bits & sign ? bits ^ sign : ~bits);
    }
    PackedRef a() const { return {static_cast<std::uint32_t>(key_and_a)}; }

    /// By key, then by the nodes, so that the order is the same with every library.
    friend bool operator<(const NearPair& x, const NearPair& y) {
        return x.key_and_a != y.key_and_a ? x.key_and_a < y.key_and_a : x.b.bits < y.b.bits;
    }

  private:
    static constexpr std::uint32_t sign = 0x80000000;

    /// Whole numbers in the order of the floats, which take one comparison with the node.
    static std::uint32_t ordered(float key) {
        const auto bits = std::bit_cast<std::uint32_t>(key + 0.0f);  // -0 is 0
        return bits & sign ? ~bits : bits ^ sign;
    }
};

/// The traversal of two packed hierarchies by distance, compiled for one layout. Of a pair of
/// nodes, the larger is divided: all its children are tested with the other at once.
template <class Codec>
class GapTraversal {
  public:
    GapTraversal(const PackedQuery<Codec>& query, const LeafQuery& leaves, std::size_t heap,
                 NearSearch& search)
        : a_(*query.a),
          b_(*query.b),
          placed_(*query.placed),
          triangles_(leaves, search),
          pending_(heap),
          search_(search) {}

    void run() {
        pending_.push({0.0f, a_.root, b_.root});
        while (!pending_.empty() && !search_.is_done) {
            const NearPair next = pending_.pop();
            if (next.key() <= search_.limit)
                divide(next.a(), next.b);
            else
                pending_.skip();
        }
        if (!search_.is_done) triangles_.finish();
        search_.n_bounded += triangles_.count();
    }

  private:
    using Node = PackedNode<Codec>;
    using Volume = typename Codec::Decoded;
    static constexpr int W = child_lanes<Codec::width>;
    using Part = ChildLanes<Codec>;
    static constexpr int n = Part::n;

    HWY_INLINE Lanes<n> margin(const Offset& o) const {
        return Lanes<n>::all(gap_bound<Volume> * float_unit * o.length + placed_.double_error);
    }
    static HWY_INLINE Volume centered(Volume volume) {
        volume.c[0] = volume.c[1] = volume.c[2] = 0;
        return volume;
    }
    static HWY_INLINE Volume own(const PackedHierarchy<Codec>& side, PackedRef ref) {
        return ref.is_leaf() ? side.leaf(ref).template own<Volume>() : side.nodes[ref.index()].own;
    }

    HWY_INLINE void divide(PackedRef i, PackedRef j) {
        if (i.is_leaf() && j.is_leaf()) return triangles_.test(i, j);
        const Volume a = own(a_, i), b = own(b_, j);
        if (j.is_leaf() || (!i.is_leaf() && a.r >= b.r))
            divide_a(i, j, b);
        else
            divide_b(i, a, j);
    }

    HWY_INLINE void divide_a(PackedRef i, PackedRef j, const Volume& b) {
        const Node& a = a_.nodes[i.index()];
        const Offset o = offset(placed_, a.own.c, a.reach, b.c, b.r);
        const Part of_b = placed(Part::all(centered(b)), placed_, Lanes3<n>::all(o.t));
        const Lanes<n> limit = Lanes<n>::all(search_.limit);
        float keys[W];
        for (int first = 0; first < W; first += n)
            gap(load_children(a.volumes, first), of_b, margin(o), limit).store(keys + first);
        push(a, keys, [&](PackedRef child) { return std::pair(child, j); });
    }

    HWY_INLINE void divide_b(PackedRef i, const Volume& a, PackedRef j) {
        const Node& b = b_.nodes[j.index()];
        const Offset o = offset(placed_, a.c, a.r, b.own.c, b.reach);
        const Part of_a = Part::all(centered(a));
        const Lanes<n> limit = Lanes<n>::all(search_.limit);
        float keys[W];
        for (int first = 0; first < W; first += n)
            gap(of_a, placed(load_children(b.volumes, first), placed_, Lanes3<n>::all(o.t)),
                margin(o), limit)
                .store(keys + first);
        push(b, keys, [&](PackedRef child) { return std::pair(i, child); });
    }

    template <class PairOf>
    HWY_INLINE void push(const Node& divided, const float* keys, PairOf pair_of) {
        search_.n_v += divided.count;
        pending_.begin_division();
        const float limit = search_.limit;
        for (std::uint32_t k = 0; k < divided.count; ++k) {
            if (!(keys[k] <= limit)) continue;
            const auto [a, b] = pair_of({divided.child[k]});
            pending_.push({keys[k], a, b});
        }
    }

    const PackedHierarchy<Codec>&a_, &b_;
    const FloatPlacement placed_;
    NearTriangles triangles_;
    LeastFirst<NearPair> pending_;
    NearSearch& search_;
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
