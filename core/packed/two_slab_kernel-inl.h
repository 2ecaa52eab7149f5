// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_TWO_SLAB_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_TWO_SLAB_KERNEL_INL_H_
#undef SCB_CORE_TWO_SLAB_KERNEL_INL_H_
#else
#define SCB_CORE_TWO_SLAB_KERNEL_INL_H_
#endif

#include "core/packed/packed_axes-inl.h"
#include "core/packed/volume_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

template <int n_>
struct LaneVolumes<PackedScb2, n_> {
    static constexpr int n = n_, rows = 17;
    /// Decoded axes are off from right angles by some 21 units, B's in A's frame by 33, cosines
    /// by 57. In sum, the part of a plane's normal besides the measured axes is off by up to 260
    /// units, distances along it by 60, and the product of the long axes by 240 in all. Squares of
    /// lengths may underflow: they are then far below the square of the error of doubles in a mesh
    /// of some size, and this error is in every margin.
    static constexpr float distance_bound = 384;
    Lanes3<n> c, axis[3];  ///< first normal, second normal, long axis
    Lanes<n> r, m[2], h[2];

    /// With the axes of the quaternion whose vector part is q.
    static HWY_INLINE LaneVolumes of(Lanes3<n> center, Lanes3<n> q, Lanes<n> radius, Lanes<n> m0,
                                     Lanes<n> m1, Lanes<n> h0, Lanes<n> h1) {
        const auto a = packed_axes(q.x, q.y, q.z, Lanes<n>::all(1));
        return {center,
                {{a.axis[0][0], a.axis[0][1], a.axis[0][2]},
                 {a.axis[1][0], a.axis[1][1], a.axis[1][2]},
                 {a.axis[2][0], a.axis[2][1], a.axis[2][2]}},
                radius,
                {m0, m1},
                {h0, h1}};
    }
    static HWY_INLINE LaneVolumes all(const PackedScb2& s) {
        return of(Lanes3<n>::all(s.c), Lanes3<n>::all(s.q), Lanes<n>::all(s.r),
                  Lanes<n>::all(s.m[0]), Lanes<n>::all(s.m[1]), Lanes<n>::all(s.h[0]),
                  Lanes<n>::all(s.h[1]));
    }

    template <int W>
    HWY_INLINE void put(float (*to)[W], int first) const {
        put_point(c, to, first);
        for (int i = 0; i < 3; ++i) put_point(axis[i], to + 3 + 3 * i, first);
        r.store(to[12] + first);
        for (int i = 0; i < 2; ++i) {
            m[i].store(to[13 + i] + first);
            h[i].store(to[15 + i] + first);
        }
    }
    template <int W>
    static HWY_INLINE LaneVolumes column(const float (*from)[W], int k) {
        const auto row = [from, k](int i) HWY_ATTR { return Lanes<n>::all(from[i][k]); };
        return {point_of<n>(from, k),
                {point_of<n>(from + 3, k), point_of<n>(from + 6, k), point_of<n>(from + 9, k)},
                row(12),
                {row(13), row(14)},
                {row(15), row(16)}};
    }
};
template <int n>
using LaneScb2s = LaneVolumes<PackedScb2, n>;

template <int width>
HWY_INLINE ChildLanes<FloatCodec<width, Scb2>> load_children(const FloatCodec<width, Scb2>& from,
                                                             int first) {
    using Children = ChildLanes<FloatCodec<width, Scb2>>;
    using L = Lanes<Children::n>;
    return Children::of(
        {L::load(from.c[0] + first), L::load(from.c[1] + first), L::load(from.c[2] + first)},
        {L::load(from.q[0] + first), L::load(from.q[1] + first), L::load(from.q[2] + first)},
        L::load(from.r + first), L::load(from.m[0] + first), L::load(from.m[1] + first),
        L::load(from.h[0] + first), L::load(from.h[1] + first));
}
template <int width>
HWY_INLINE ChildLanes<QuantizedCodec<width, Scb2>> load_children(
    const QuantizedCodec<width, Scb2>& from, int first) {
    using Children = ChildLanes<QuantizedCodec<width, Scb2>>;
    using L = Lanes<Children::n>;
    // All are powers of two: products are exact.
    const L length = L::all(from.length_unit), unit = L::all(direction_unit),
            first_slab = L::all(from.slab_unit[0]), second_slab = L::all(from.slab_unit[1]);
    return Children::of({L::load(from.c[0] + first) * length, L::load(from.c[1] + first) * length,
                         L::load(from.c[2] + first) * length},
                        {L::load(from.q[0] + first) * unit, L::load(from.q[1] + first) * unit,
                         L::load(from.q[2] + first) * unit},
                        L::load(from.r + first) * length, L::load(from.m[0] + first) * first_slab,
                        L::load(from.m[1] + first) * second_slab,
                        L::load(from.h[0] + first) * first_slab,
                        L::load(from.h[1] + first) * second_slab);
}

/// The volumes of B in A's frame.
template <int n>
HWY_INLINE LaneScb2s<n> placed(const LaneScb2s<n>& b, const FloatPlacement& placement,
                               const Lanes3<n>& translation) {
    LaneScb2s<n> moved = b;
    moved.c = rotate(placement, b.c) + translation;
    for (int i = 0; i < 3; ++i) moved.axis[i] = rotate(placement, b.axis[i]);
    return moved;
}

/// The lanes of n volumes that reach a slab with half the thickness `h`. Their centers are at the
/// distance d from its middle, and `normal` is its normal along the axes of each volume. The extent
/// of a volume along the normal has three upper bounds: its radius; the box of the slabs and the
/// radius; and the cylinder about its first slab. The last helps for flat volumes face to face: it
/// saves a tenth of the tests along first normals, and would save a hundredth along second normals,
/// where it is not used.
template <bool with_cylinder, int n>
HWY_INLINE LaneMask<n> reach_slab(Lanes<n> d, Lanes<n> h, const LaneScb2s<n>& volume,
                                  const Lanes3<n>& normal) {
    const auto& [c0, c1, c2] = normal;
    const Lanes<n> by_first = d + c0 * volume.m[0], of_first = h + abs(c0) * volume.h[0];
    LaneMask<n> reached =
        (abs(d) - h <= volume.r) &
        (abs(by_first + c1 * volume.m[1]) <= of_first + abs(c1) * volume.h[1] + abs(c2) * volume.r);
    if constexpr (with_cylinder) {
        const Lanes<n> gap = max(abs(by_first) - of_first, Lanes<n>::all(0));
        reached = reached & (gap * gap <= volume.r * volume.r * (c1 * c1 + c2 * c2));
    }
    return reached;
}

/// The lanes of n pairs of volumes that overlap or are within `margin`. Tests the balls, each slab
/// against the other volume, and the product of the long axes, along which the slabs alone bound a
/// volume's extent: all stages of overlap_scb2 at once except the line of centers, with bounds in
/// place of exact extents.
template <int n>
HWY_INLINE LaneMask<n> overlap(const LaneScb2s<n>& a, const LaneScb2s<n>& b, Lanes<n> margin) {
    const Lanes3<n> c = b.c - a.c;
    const Lanes<n> sum = a.r + b.r + margin;

    // Row i is A's axis i in B's frame, column j is B's axis j in A's frame. The product of the two
    // long axes is not needed.
    const auto row = [&](int i) HWY_ATTR {
        return Lanes3<n>{dot(a.axis[i], b.axis[0]), dot(a.axis[i], b.axis[1]),
                         dot(a.axis[i], b.axis[2])};
    };
    const Lanes3<n> of_a[2] = {row(0), row(1)};
    const Lanes<n> line0 = dot(a.axis[2], b.axis[0]), line1 = dot(a.axis[2], b.axis[1]);
    const Lanes3<n> of_b[2] = {{of_a[0].x, of_a[1].x, line0}, {of_a[0].y, of_a[1].y, line1}};
    // From the middles of slabs to the other's center.
    const Lanes<n> to_b0 = dot(a.axis[0], c) - a.m[0], to_b1 = dot(a.axis[1], c) - a.m[1],
                   to_a0 = -dot(b.axis[0], c) - b.m[0], to_a1 = -dot(b.axis[1], c) - b.m[1];
    const LaneMask<n> slabs = reach_slab<true>(to_b0, a.h[0] + margin, b, of_a[0]) &
                              reach_slab<false>(to_b1, a.h[1] + margin, b, of_a[1]) &
                              reach_slab<true>(to_a0, b.h[0] + margin, a, of_b[0]) &
                              reach_slab<false>(to_a1, b.h[1] + margin, a, of_b[1]);

    const Lanes<n> x = of_a[0].z, y = of_a[1].z;
    const Lanes<n> apart = x * to_b1 - y * to_b0 + line1 * b.m[0] - line0 * b.m[1];
    const Lanes<n> reach =
        abs(y) * a.h[0] + abs(x) * a.h[1] + abs(line1) * b.h[0] + abs(line0) * b.h[1];
    return (dot(c, c) <= sum * sum) & slabs & (abs(apart) <= reach + margin);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
