// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_LEAF_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_LEAF_PAIRS_INL_H_
#undef SCB_CORE_LEAF_PAIRS_INL_H_
#else
#define SCB_CORE_LEAF_PAIRS_INL_H_
#endif

#include <bit>
#include <cstring>

#include "core/packed/float_placement-inl.h"
#include "core/packed/packed_query.h"
#include "core/packed/triangle_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The sources of lanes that have the first of four numbers four times, then the second and so on,
/// in vectors of n lanes.
template <int n>
struct SpreadFrom {
    static constexpr int four = most_leaf_triangles;
    alignas(64) std::int32_t lane[four * four] = {};
    constexpr SpreadFrom() {
        for (int k = 0; k < four * four; ++k) lane[k] = k / four + k % n / four * four;
    }
};
template <int n>
inline constexpr SpreadFrom<n> spread_from{};

/// The errors of the numbers of TrianglePairs, from the radii r_a and r_b of the leaves and the
/// offset t of their centers. All errors are multiples of u, which is left out here:
/// - a corner in its leaf: the radius, r_a or r_b;
/// - an edge of A: 2 r_a for its corners, 2 r_a for the rounding of their difference;
/// - a corner of B, rotated: r_b for the corner, r_b for the rounded matrix, 3 r_b for three
///   roundings of each term;
/// - an edge of B: 10 r_b for its corners, 2 r_b for the rounding;
/// - t: |t|;
/// - t minus the first corner of A: |t| and r_a from above, and |t| + r_a for the rounding;
/// - this plus the first corner of B: 5 r_b from above, and r_a + r_b + |t| for the rounding.
/// The last is 3 r_a + 6 r_b + 3 |t| in all, at most 6 times the length of `offset`,
/// r_a + r_b + |t|.
inline constexpr float edge_error_a = 4.1f, edge_error_b = 12.3f, offset_error = 6.2f;
/// Corners of the smallest triangles lose digits to the least exponent of floats.
inline constexpr float least_error = 0x1p-120f;

/// Calls `use` with each row of OpenPairs::points, and the numbers of these pairs in it.
template <int n, class Use>
HWY_INLINE void each_row(const TrianglePairs<n>& pairs, Use use) {
    const Lanes3<n>* const points[] = {&pairs.p1, &pairs.p2, &pairs.f1, &pairs.f2, &pairs.w};
    for (int k = 0; k < 5; ++k) {
        use(3 * k, points[k]->x);
        use(3 * k + 1, points[k]->y);
        use(3 * k + 2, points[k]->z);
    }
    use(15, pairs.error_p);
    use(16, pairs.error_f);
    use(17, pairs.error_w);
}

/// n open pairs, from index `at` on.
template <int n>
HWY_INLINE TrianglePairs<n> triangle_pairs(const OpenPairs& open, std::size_t at) {
    const auto lanes = [&open, at](int row)
                           HWY_ATTR { return Lanes<n>::load(open.points[row] + at); };
    const auto point = [&lanes](int k) HWY_ATTR {
        return Lanes3<n>{lanes(3 * k), lanes(3 * k + 1), lanes(3 * k + 2)};
    };
    return {point(0), point(1), point(2), point(3), point(4), lanes(15), lanes(16), lanes(17)};
}

/// Tests pairs of leaves for triangles that intersect.
class LeafPairs {
  public:
    LeafPairs(const LeafQuery& query, OpenPairs& open, PackedFindings& found)
        : a_(query.a),
          b_(query.b),
          placed_(*query.placed),
          skin_(query.skin),
          open_(open),
          found_(found) {}

    /// Tests all pairs of the list, and empties it.
    void run(RefPairs& list) {
        if (skin_ > 0)
            run(list, [this](std::uint32_t i, std::uint32_t j) HWY_ATTR { keep_near(i, j); });
        else
            run(list, [this](std::uint32_t i, std::uint32_t j) HWY_ATTR { leaf_leaf(i, j); });
    }

    /// Decides all open pairs.
    void finish() { decide(); }

    /// Calls `each` with the pairs of triangles of two leaves, a vector at a time: the pairs, the
    /// bits of lanes that have one, the leaves, and the first lane.
    template <class Each>
    HWY_INLINE void for_each_part(std::uint32_t i, std::uint32_t j, Each each) {
        const PackedLeaf a = leaf(a_, i, gathered_a_), b = leaf(b_, j, gathered_b_);
        if (j != turned_leaf_) turn(b);  // often it is the leaf of the pair before
        turned_leaf_ = j;
        const Offset o = offset(placed_, a.center(), a.radius(), b.center(), b.radius());
        const std::uint32_t count_a = a.count(), count_b = b.count();
        found_.n_p += count_a * count_b;
        const std::uint32_t valid = low_bits(count_a) * 0x1111u;  // each four lanes have A's
                                                                  // triangles
        // The exact test rounds two corners of an edge of B.
        const Lanes<n> error_p =
                           Lanes<n>::all(edge_error_a * float_unit * a.radius() + least_error),
                       error_f = Lanes<n>::all(edge_error_b * float_unit * b.radius() +
                                               2 * placed_.double_error),
                       error_w = Lanes<n>::all(offset_error * float_unit * o.length +
                                               placed_.double_error);
        const Lanes3<n> t = Lanes3<n>::all(o.t);
        const int lanes = static_cast<int>(count_b) * side;
        for (int first = 0; first < lanes; first += n) {
            const Lanes3<n> p0 = corner_a(a, 0, first);
            const TrianglePairs<n> pairs = {corner_a(a, 1, first) - p0,
                                            corner_a(a, 2, first) - p0,
                                            turned(1, first),
                                            turned(2, first),
                                            turned(0, first) + (t - p0),
                                            error_p,
                                            error_f,
                                            error_w};
            each(pairs, (valid & low_bits(static_cast<std::uint32_t>(lanes))) >> first, a, b,
                 first);
        }
    }

  private:
    template <class Test>
    HWY_INLINE void run(RefPairs& list, Test test) {
        const std::size_t count = list.size();
        const std::uint32_t *a = list.a_begin(), *b = list.b_begin();
        for (std::size_t i = 0; i < count && i < ahead; ++i) prefetch_pair(a[i], b[i]);
        for (std::size_t i = 0; i < count; ++i) {
            if (i + ahead < count) prefetch_pair(a[i + ahead], b[i + ahead]);
            test(a[i], b[i]);
        }
        list.clear();
    }

    static constexpr std::size_t ahead = 4;  // in pairs
    // A leaf of A has its triangles in lanes 0 to 3, 4 to 7 and so on, a leaf of B its
    // first triangle in the first four, its second in the next.
    static constexpr int side = most_leaf_triangles, n = part_lanes(side * side);

    HWY_INLINE void prefetch_pair(std::uint32_t i, std::uint32_t j) const {
        prefetch_leaf(a_.words + PackedRef{i}.index());
        prefetch_leaf(b_.words + PackedRef{j}.index());
    }

    /// A leaf with its corners, which are gathered if not stored; often it is the leaf of the call
    /// before.
    struct Gathered {
        std::uint32_t ref = 0;  // 0: no leaf
        // Whole vectors are loaded at the last numbers, so some more must be allocated.
        float words[PackedLeaf::size(side, LeafCorners::stored) + side] = {};
    };
    HWY_INLINE PackedLeaf leaf(const PackedLeaves& leaves, std::uint32_t ref, Gathered& gathered) {
        const PackedLeaf bare{leaves.words + PackedRef{ref}.index()};
        if (leaves.mesh == nullptr) return bare;
        if (gathered.ref != ref) {
            gathered.ref = ref;
            std::memcpy(gathered.words, bare.words,
                        4 * PackedLeaf::size(bare.count(), LeafCorners::in_mesh));
            PackedLeaf::write_corners(gathered.words, *leaves.mesh);
        }
        return {gathered.words};
    }

    /// Lanes `first` and on of four numbers, tiled.
    static HWY_INLINE Lanes<n> tiled(const float* four, int first) {
        if constexpr (n < side)
            return {hn::LoadU(typename Lanes<n>::D(), four + first % side)};
        else
            return {hn::LoadDup128(typename Lanes<n>::D(), four)};
    }
    /// The same, spread.
    static HWY_INLINE Lanes<n> spread(const float* four, int first) {
        const typename Lanes<n>::D d;
        if constexpr (n <= side) {
            return {hn::Set(d, four[first / side])};
        } else {
            return {hn::TableLookupLanes(hn::LoadDup128(d, four),
                                         hn::SetTableIndices(d, spread_from<n>.lane + first))};
        }
    }

    /// Rotates the triangles of a leaf of B into A's frame, without the translation: the first
    /// corner, and the edges from there to the others.
    HWY_INLINE void turn(const PackedLeaf& b) {
        constexpr int m = part_lanes(side);
        const std::uint32_t count = b.count();
        for (int first = 0; first < side; first += m) {
            const auto corner = [&](std::uint32_t i) HWY_ATTR {
                const float* at = b.corners() + 3 * i * count + first;
                return rotate(placed_, Lanes3<m>{Lanes<m>::load(at), Lanes<m>::load(at + count),
                                                 Lanes<m>::load(at + 2 * count)});
            };
            const auto store = [&](std::uint32_t i, Lanes3<m> lanes) HWY_ATTR {
                lanes.x.store(turned_[3 * i] + first);
                lanes.y.store(turned_[3 * i + 1] + first);
                lanes.z.store(turned_[3 * i + 2] + first);
            };
            const Lanes3<m> origin = corner(0);
            store(0, origin);
            store(1, corner(1) - origin);
            store(2, corner(2) - origin);
        }
    }

    HWY_INLINE Lanes3<n> corner_a(const PackedLeaf& a, std::uint32_t corner, int first) const {
        const std::uint32_t count = a.count();
        const float* x = a.corners() + 3 * corner * count;
        return {tiled(x, first), tiled(x + count, first), tiled(x + 2 * count, first)};
    }
    /// The first corner of a leaf of B, or an edge from there.
    HWY_INLINE Lanes3<n> turned(std::uint32_t i, int first) const {
        return {spread(turned_[3 * i], first), spread(turned_[3 * i + 1], first),
                spread(turned_[3 * i + 2], first)};
    }

    HWY_INLINE void leaf_leaf(std::uint32_t i, std::uint32_t j) {
        for_each_part(i, j,
                      [this](const TrianglePairs<n>& pairs, std::uint32_t valid,
                             const PackedLeaf& a, const PackedLeaf& b, int first) HWY_ATTR {
                          const std::uint32_t bits = planes_meet(pairs).bits() & valid;
                          if (bits != 0) put(pairs, bits, a, b, first);
                      });
    }

    /// Keeps a pair of leaves for the front if triangles may be no farther apart than the skin.
    HWY_INLINE void keep_near(std::uint32_t i, std::uint32_t j) {
        std::uint32_t near = 0;
        for_each_part(i, j,
                      [&](const TrianglePairs<n>& pairs, std::uint32_t valid, const PackedLeaf&,
                          const PackedLeaf&, int) HWY_ATTR {
                          near |= planes_near(pairs, Lanes<n>::all(skin_)).bits() & valid;
                      });
        if (near != 0) found_.kept.leaf_leaf.add(i, j);
    }

    /// Collects pairs of a batch until there are enough to decide.
    HWY_INLINE void put(const TrianglePairs<n>& pairs, std::uint32_t bits, const PackedLeaf& a,
                        const PackedLeaf& b, int first) {
        const std::size_t at = open_.count;
        const ChosenLanes<n> chosen(bits);
        const auto store = [at, &chosen](float* row, Lanes<n> lanes)
                               HWY_ATTR { Lanes<n>{chosen(lanes.v)}.store(row + at); };
        store(open_.a, tiled(a.triangle_bits(), first));
        store(open_.b, spread(b.triangle_bits(), first));
        each_row(pairs, [this, &store](int row, Lanes<n> lanes)
                            HWY_ATTR { store(open_.points[row], lanes); });
        open_.count += static_cast<std::size_t>(std::popcount(bits));
        if (open_.count >= OpenPairs::enough) decide();
    }

    /// Decides the last open pairs, n at most.
    HWY_INLINE void decide_some() {
        const std::size_t count = open_.count < std::size_t{n} ? open_.count : std::size_t{n};
        open_.count -= count;
        const std::size_t at = open_.count;
        const Certainty<n> result = intersection(triangle_pairs<n>(open_, at));
        std::uint32_t yes = result.intersect.bits() & low_bits(static_cast<std::uint32_t>(count));
        std::uint32_t unsure =
            result.open.bits() & low_bits(static_cast<std::uint32_t>(count)) & ~yes;
        for (; yes != 0; yes &= yes - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(yes));
            found_.pairs.push_back(open_.pair(k));
        }
        for (; unsure != 0; unsure &= unsure - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(unsure));
            found_.undecided.push_back(open_.pair(k));
        }
    }
    void decide() {
        while (open_.count > 0) decide_some();
    }

    const PackedLeaves a_, b_;
    Gathered gathered_a_, gathered_b_;
    const FloatPlacement placed_;
    const float skin_;
    OpenPairs& open_;
    PackedFindings& found_;
    std::uint32_t turned_leaf_ = 0;  // 0: no leaf
    float turned_[9][side] = {};
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
