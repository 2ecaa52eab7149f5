// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_NEAR_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_NEAR_TRIANGLES_INL_H_
#undef SCB_CORE_NEAR_TRIANGLES_INL_H_
#else
#define SCB_CORE_NEAR_TRIANGLES_INL_H_
#endif

#include <bit>
#include <cmath>
#include <limits>

#include "core/packed/leaf_pairs-inl.h"
#include "core/packed/near_search.h"
#include "core/packed/triangle_gap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Hands over the near triangles of pairs of leaves. Most pairs are far enough apart along the
/// vector between the nearest triangles so far, or between their centers. The others wait until
/// there are enough for all lanes, and are then bounded from both sides.
class NearTriangles {
  public:
    NearTriangles(const LeafQuery& query, NearSearch& search)
        : leaf_pairs_(query, open_, findings_), search_(search) {}

    /// Tests the triangles of two leaves. Some pairs may wait until finish.
    void test(PackedRef i, PackedRef j) {
        leaf_pairs_.for_each_part(
            i.bits, j.bits,
            [this]<int n>(const TrianglePairs<n>& pairs, std::uint32_t valid, const PackedLeaf& a,
                          const PackedLeaf& b, int first) HWY_ATTR {
                std::uint32_t bits = valid & low_bits(n) & ~far_along_nearest(pairs).bits();
                if (bits != 0) bits &= ~far_along_centers(pairs).bits();
                if (bits != 0) put(pairs, bits, a, b, first);
            });
        // The first limit is needed soonest.
        constexpr std::size_t enough = 8;
        if (open_.count >= enough || !(search_.limit < std::numeric_limits<float>::max())) finish();
    }

    /// Hands over the pairs that wait.
    void finish() {
        constexpr int n = part_lanes(8);
        for (std::size_t i = 0; i < open_.count; i += n) {
            const std::size_t count = open_.count - i;
            bound<n>(i, count < n ? count : n);
        }
        open_.count = 0;
    }

    /// The number of pairs of triangles of all leaves so far.
    std::uint64_t count() const { return findings_.n_p; }

  private:
    /// Whether the gaps along these vectors, at most this long, are above the limit.
    template <int n>
    HWY_INLINE LaneMask<n> far_along(const TrianglePairs<n>& pairs, const Lanes3<n>& v,
                                     Lanes<n> length) const {
        const Lanes<n> most = Lanes<n>::all(search_.limit) + gap_error(pairs);
        return most * length < gap_along(pairs, v);
    }
    template <int n>
    HWY_INLINE LaneMask<n> far_along_nearest(const TrianglePairs<n>& pairs) const {
        return far_along(pairs, Lanes3<n>::all(direction_), Lanes<n>::all(direction_length_));
    }
    /// Along the vector between the centers of each pair. This costs more. It ends pairs that lie
    /// beside each other on nearly parallel surfaces.
    template <int n>
    HWY_INLINE LaneMask<n> far_along_centers(const TrianglePairs<n>& t) const {
        const Lanes<n> three = Lanes<n>::all(3);
        const Lanes3<n> v = (t.f1 + t.f2) - (t.p1 + t.p2) + scaled(three, t.w);
        const Lanes<n> length = sqrt(dot(v, v));
        return has_direction(length) & far_along(t, v, length * Lanes<n>::all(1 + 0x1p-20f));
    }

    template <int n>
    HWY_INLINE void put(const TrianglePairs<n>& pairs, std::uint32_t bits, const PackedLeaf& a,
                        const PackedLeaf& b, int first) {
        const std::size_t at = open_.count;
        const ChosenLanes<n> chosen(bits);
        const auto store = [at, &chosen](float* row, Lanes<n> lanes)
                               HWY_ATTR { Lanes<n>{chosen(lanes.v)}.store(row + at); };
        each_row(pairs, [this, &store](int row, Lanes<n> lanes)
                            HWY_ATTR { store(open_.points[row], lanes); });
        constexpr int side = most_leaf_triangles;
        for (; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(first + std::countr_zero(bits));
            open_.a[open_.count] = a.triangle_bits()[lane % side];
            open_.b[open_.count++] = b.triangle_bits()[lane / side];
        }
    }

    /// Bounds the distances of n pairs. The first `count` of them are valid.
    template <int n>
    HWY_INLINE void bound(std::size_t at, std::size_t count) {
        const TriangleGap<n> gap(triangle_pairs<n>(open_, at));
        float least[n], most[n];
        gap.least.store(least);
        gap.most.store(most);
        for (std::size_t k = 0; k < count; ++k) {
            if (!(least[k] <= search_.limit)) continue;
            if (most[k] < nearest_) {
                nearest_ = most[k];
                keep_direction(gap.v, k);
            }
            search_.take(open_.pair(at + k), least[k], most[k]);
        }
    }

    template <int n>
    HWY_INLINE void keep_direction(const Lanes3<n>& v, std::size_t k) {
        float x[n], y[n], z[n];
        v.x.store(x);
        v.y.store(y);
        v.z.store(z);
        // Squares of shorter and longer vectors leave the range of floats.
        const float length = std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
        if (!(length > shortest_gap && length < longest_gap)) return;
        direction_[0] = x[k];
        direction_[1] = y[k];
        direction_[2] = z[k];
        direction_length_ = length * (1 + 0x1p-20f);
    }

    OpenPairs open_;
    PackedFindings findings_;  // has the count alone
    LeafPairs leaf_pairs_;
    NearSearch& search_;
    float nearest_ = HUGE_VALF;
    float direction_[3] = {0, 0, 0}, direction_length_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
