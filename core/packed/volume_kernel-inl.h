// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_VOLUME_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_VOLUME_KERNEL_INL_H_
#undef SCB_CORE_VOLUME_KERNEL_INL_H_
#else
#define SCB_CORE_VOLUME_KERNEL_INL_H_
#endif

#include "core/base/lanes-inl.h"
#include "core/packed/float_placement-inl.h"
#include "scb/node_codec.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Three rows of a table, the coordinates of one point per column.
template <int n, int W>
HWY_INLINE void put_point(const Lanes3<n>& point, float (*to)[W], int first) {
    point.x.store(to[0] + first);
    point.y.store(to[1] + first);
    point.z.store(to[2] + first);
}

template <int n, int W>
HWY_INLINE Lanes3<n> point_of(const float (*from)[W], int k) {
    return {Lanes<n>::all(from[0][k]), Lanes<n>::all(from[1][k]), Lanes<n>::all(from[2][k])};
}

/// n volumes in one frame, see PackedScb and PackedScb2. Their numbers can be stored as rows of a
/// table, and one column can be loaded into all lanes. Distances that overlap computes are off by
/// up to `distance_bound` units of the length of an Offset.
template <class Packed, int n_>
struct LaneVolumes;

template <int n_>
struct LaneVolumes<PackedScb, n_> {
    static constexpr int n = n_, rows = 9;
    /// A center of B is off by some 18 units, its normal by 12, distances along both normals and
    /// their cosine by 60 in all, and radii times the sine by 20.
    static constexpr float distance_bound = 96;
    Lanes3<n> c, normal;
    Lanes<n> r, m, h;

    static HWY_INLINE LaneVolumes all(const PackedScb& s) {
        return {Lanes3<n>::all(s.c), Lanes3<n>::all(s.n), Lanes<n>::all(s.r), Lanes<n>::all(s.m),
                Lanes<n>::all(s.h)};
    }
    template <int W>
    HWY_INLINE void put(float (*to)[W], int first) const {
        put_point(c, to, first);
        put_point(normal, to + 3, first);
        r.store(to[6] + first);
        m.store(to[7] + first);
        h.store(to[8] + first);
    }
    template <int W>
    static HWY_INLINE LaneVolumes column(const float (*from)[W], int k) {
        return {point_of<n>(from, k), point_of<n>(from + 3, k), Lanes<n>::all(from[6][k]),
                Lanes<n>::all(from[7][k]), Lanes<n>::all(from[8][k])};
    }
};
template <int n>
using LaneScbs = LaneVolumes<PackedScb, n>;

/// The number of lanes for the children of a node of this width: at least as many as any target
/// loads at a time.
template <int width>
inline constexpr int child_lanes = width < 4 ? 4 : width;
template <class Codec>
using ChildLanes = LaneVolumes<typename Codec::Decoded, part_lanes(child_lanes<Codec::width>)>;

/// Children of a node, from index `first` on, in its own frame. Lanes behind the last child have no
/// meaning.
template <int width>
HWY_INLINE ChildLanes<FloatCodec<width>> load_children(const FloatCodec<width>& from, int first) {
    using L = Lanes<ChildLanes<FloatCodec<width>>::n>;
    return {{L::load(from.c[0] + first), L::load(from.c[1] + first), L::load(from.c[2] + first)},
            {L::load(from.n[0] + first), L::load(from.n[1] + first), L::load(from.n[2] + first)},
            L::load(from.r + first),
            L::load(from.m + first),
            L::load(from.h + first)};
}
template <int width>
HWY_INLINE ChildLanes<QuantizedCodec<width>> load_children(const QuantizedCodec<width>& from,
                                                           int first) {
    using L = Lanes<ChildLanes<QuantizedCodec<width>>::n>;
    // All are powers of two: products are exact.
    const L length = L::all(from.length_unit), slab = L::all(from.slab_unit),
            unit = L::all(direction_unit);
    return {{L::load(from.c[0] + first) * length, L::load(from.c[1] + first) * length,
             L::load(from.c[2] + first) * length},
            {L::load(from.n[0] + first) * unit, L::load(from.n[1] + first) * unit,
             L::load(from.n[2] + first) * unit},
            L::load(from.r + first) * length,
            L::load(from.m + first) * slab,
            L::load(from.h + first) * slab};
}

/// The volumes of B in A's frame.
template <int n>
HWY_INLINE LaneScbs<n> placed(const LaneScbs<n>& b, const FloatPlacement& placement,
                              const Lanes3<n>& translation) {
    return {rotate(placement, b.c) + translation, rotate(placement, b.normal), b.r, b.m, b.h};
}

/// The lanes of n pairs of volumes that overlap or are within `margin`: the symmetric form of
/// Figure 8, all stages at once, see overlap_symmetric. |sin| is from the cross product of the
/// normals: 1 - cos^2 cancels if slabs are nearly parallel.
template <int n>
HWY_INLINE LaneMask<n> overlap(const LaneScbs<n>& a, const LaneScbs<n>& b, Lanes<n> margin) {
    const Lanes3<n> c = b.c - a.c;
    const Lanes<n> reach_a = a.r + margin, reach_b = b.r + margin, sum = a.r + reach_b;
    LaneMask<n> together = dot(c, c) <= sum * sum;

    const Lanes<n> d0 = dot(a.normal, c) - a.m, d1 = dot(b.normal, c) + b.m,
                   cosine = dot(a.normal, b.normal);
    together = together & (abs(d0) - a.h <= reach_b) & (abs(d1) - b.h <= reach_a);

    const Lanes3<n> normals = cross(a.normal, b.normal);
    const Lanes<n> squared_sine = dot(normals, normals), tilt = abs(cosine),
                   zero = Lanes<n>::all(0);
    const Lanes<n> gap_a = max(abs(d0 + b.m * cosine) - a.h - b.h * tilt - margin, zero);
    const Lanes<n> gap_b = max(abs(d1 - a.m * cosine) - b.h - a.h * tilt - margin, zero);
    return together & (gap_a * gap_a <= b.r * b.r * squared_sine) &
           (gap_b * gap_b <= a.r * a.r * squared_sine);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
