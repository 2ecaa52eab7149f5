// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_GAP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_GAP_KERNEL_INL_H_
#undef SCB_CORE_GAP_KERNEL_INL_H_
#else
#define SCB_CORE_GAP_KERNEL_INL_H_
#endif

#include "core/packed/two_slab_kernel-inl.h"
#include "core/packed/volume_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// Lower bounds of the distances of n pairs of volumes in floats: volume_gap in lanes.
//
// A direction is a vector as it was computed, and a gap belongs to the exact extents along it. So
// only the numbers along the direction have errors, and lengths where a gap is divided by one.
// Each gap is reduced by `gap_bound` units of the length of an Offset, which bounds coordinates,
// and by the error of doubles. Errors in units of this length:
//
// Two slabs, see LaneVolumes<PackedScb2>::distance_bound: an extent is off by 260 for the part of
// a direction besides the measured axes, and by 60 for distances. The long axis, where it is a
// direction, is off from length 1 by 22, and so are distances along it. The line of the centers
// adds 18 for the center of B, which is a point there and not only a direction. The product of the
// long axes is off by 240, before it is divided. Sums and roots of these add less than 40.
// One slab: the center of B is off by 18, its normal by 12, a cosine and a sine by 20 each, a
// distance from an axis by 26. The largest sum has the center, a cosine and a sine of B and sums:
// less than 100. Where normals are too short, radii and slabs are larger, see node_codec.cpp.
template <class Packed>
inline constexpr float gap_bound = 448;
template <>
inline constexpr float gap_bound<PackedScb> = 128;

/// The root of squared gaps along directions at right angles exceeds the distance by no more than
/// half of the errors of the directions, squares and lengths: 110 units for the axes of B in A's
/// frame, with both lengths.
inline constexpr float root_of_squares = 1 - 0x1p-17f;

/// Added to lengths that divide. Where a direction has no length, its gap is not positive.
inline constexpr float least_length = 0x1p-60f;

/// The key of a pair of volumes: the largest bound of their distance where it is above 0, else a
/// number that is the less, the more the balls overlap. Squares of lengths beyond the range of
/// floats count as no bound.
template <int n>
HWY_INLINE Lanes<n> gap_key(Lanes<n> bound, Lanes<n> of_balls) {
    const Lanes<n> zero = Lanes<n>::all(0), most = Lanes<n>::all(0x1p120f);
    const Lanes<n> order = select(of_balls < zero, of_balls, zero);
    return select((zero < bound) & (bound < most), bound, order);
}

template <int n>
HWY_INLINE Lanes<n> above_zero(Lanes<n> gap) {
    return max(gap, Lanes<n>::all(0));
}

/// The key of each of n pairs, see gap_key: along the line of the centers, the root of squares of
/// the gaps along and beside A's normal, and the same about B's.
template <int n>
HWY_INLINE Lanes<n> gap(const LaneScbs<n>& a, const LaneScbs<n>& b, Lanes<n> margin, Lanes<n>) {
    const Lanes3<n> c = b.c - a.c;
    const Lanes<n> squared = dot(c, c), distance = sqrt(squared), of_balls = distance - a.r - b.r;
    const Lanes<n> along_a = dot(a.normal, c), along_b = dot(b.normal, c),
                   cosine = dot(a.normal, b.normal), tilt = abs(cosine);
    const auto length = [](Lanes3<n> v) HWY_ATTR { return sqrt(dot(v, v)); };
    const Lanes<n> sine = length(cross(a.normal, b.normal)), beside_a = length(cross(a.normal, c)),
                   beside_b = length(cross(b.normal, c));

    // Beside a normal, only the balls bound the extents.
    const Lanes<n> radii = a.r + b.r + margin;
    const auto about = [&](Lanes<n> d, Lanes<n> tilted, Lanes<n> beside, Lanes<n> h,
                           Lanes<n> other_h, Lanes<n> other_r) HWY_ATTR {
        const Lanes<n> along = above_zero(
            max(abs(d) - other_r, abs(tilted) - tilt * other_h - sine * other_r) - h - margin);
        const Lanes<n> across = above_zero(beside - radii);
        return sqrt(along * along + across * across);
    };
    const Lanes<n> d0 = along_a - a.m, d1 = along_b + b.m;
    const Lanes<n> of_a = about(d0, d0 + b.m * cosine, beside_a, a.h, b.h, b.r),
                   of_b = about(d1, d1 - a.m * cosine, beside_b, b.h, a.h, a.r);

    // Times the distance.
    const Lanes<n> reach_a =
        min(a.r * distance, along_a * a.m + abs(along_a) * a.h + beside_a * a.r);
    const Lanes<n> reach_b =
        min(b.r * distance, abs(along_b) * b.h - along_b * b.m + beside_b * b.r);
    const Lanes<n> of_line =
        (squared - reach_a - reach_b) / (distance + Lanes<n>::all(least_length)) - margin;

    return gap_key(
        max(max(of_balls - margin, of_line), max(of_a, of_b) * Lanes<n>::all(root_of_squares)),
        of_balls);
}

/// The gap between two extents on an axis: the interval from -h to h, and the extent of a volume
/// whose center is at d. `part`: the direction of the axis, along the axes of the volume. Its
/// extent has three upper bounds, as in reach_slab.
template <int n>
HWY_INLINE Lanes<n> gap_along(Lanes<n> d, Lanes<n> h, const LaneScb2s<n>& volume,
                              const Lanes3<n>& part) {
    const auto& [c0, c1, c2] = part;
    const Lanes<n> by_first = d + c0 * volume.m[0], of_first = abs(c0) * volume.h[0];
    const Lanes<n> of_box =
        abs(by_first + c1 * volume.m[1]) - abs(c1) * volume.h[1] - abs(c2) * volume.r;
    const Lanes<n> of_cylinder = abs(by_first) - volume.r * sqrt(c1 * c1 + c2 * c2);
    return max(abs(d) - volume.r, max(of_box, of_cylinder) - of_first) - h;
}

/// How far a volume reaches from its center along the direction with these parts along its axes,
/// times the direction's length.
template <int n>
HWY_INLINE Lanes<n> reach_along(const LaneScb2s<n>& volume, const Lanes3<n>& part,
                                Lanes<n> length) {
    const auto& [c0, c1, c2] = part;
    const Lanes<n> of_first = c0 * volume.m[0] + abs(c0) * volume.h[0],
                   of_box = c1 * volume.m[1] + abs(c1) * volume.h[1] + abs(c2) * volume.r,
                   of_cylinder = volume.r * sqrt(c1 * c1 + c2 * c2);
    return min(volume.r * length, of_first + min(of_box, of_cylinder));
}

/// The key of each of n pairs, see gap_key: along the line of the centers, the root of squares of
/// the gaps along A's axes, the same along B's axes, and along the product of the long axes. If the
/// first bounds of all pairs are above `limit`, the others are not computed.
template <int n>
HWY_INLINE Lanes<n> gap(const LaneScb2s<n>& a, const LaneScb2s<n>& b, Lanes<n> margin,
                        Lanes<n> limit) {
    const Lanes3<n> c = b.c - a.c;
    const Lanes<n> squared = dot(c, c), distance = sqrt(squared), of_balls = distance - a.r - b.r;
    const auto along = [](const LaneScb2s<n>& volume, const Lanes3<n>& v) HWY_ATTR {
        return Lanes3<n>{dot(volume.axis[0], v), dot(volume.axis[1], v), dot(volume.axis[2], v)};
    };
    // Row i is A's axis i along B's axes.
    const Lanes3<n> row0 = along(b, a.axis[0]), row1 = along(b, a.axis[1]),
                    row2 = along(b, a.axis[2]);
    const Lanes3<n> of_a = along(a, c), of_b = along(b, -c);
    const Lanes<n> to_b0 = of_a.x - a.m[0], to_b1 = of_a.y - a.m[1], to_a0 = of_b.x - b.m[0],
                   to_a1 = of_b.y - b.m[1];

    const auto root = [margin](Lanes<n> x, Lanes<n> y, Lanes<n> z) HWY_ATTR {
        x = above_zero(x - margin);
        y = above_zero(y - margin);
        z = above_zero(z - margin);
        return sqrt(x * x + y * y + z * z);
    };
    const Lanes<n> by_a = root(gap_along(to_b0, a.h[0], b, row0), gap_along(to_b1, a.h[1], b, row1),
                               gap_along(of_a.z, a.r, b, row2));
    const Lanes<n> first = max(of_balls - margin, by_a * Lanes<n>::all(root_of_squares));
    if ((first <= limit).bits() == 0) return gap_key(first, of_balls);
    const Lanes<n> by_b = root(gap_along(to_a0, b.h[0], a, Lanes3<n>{row0.x, row1.x, row2.x}),
                               gap_along(to_a1, b.h[1], a, Lanes3<n>{row0.y, row1.y, row2.y}),
                               gap_along(of_b.z, b.r, a, Lanes3<n>{row0.z, row1.z, row2.z}));

    const Lanes<n> least = Lanes<n>::all(least_length);
    const Lanes<n> by_line =
        (squared - reach_along(a, of_a, distance) - reach_along(b, of_b, distance)) /
            (distance + least) -
        margin;

    // The slabs alone bound the extents along the product, as in `overlap`. Its length is at most
    // this: the axes are off by 64 units in all.
    const Lanes<n> x = row0.z, y = row1.z;
    const Lanes<n> apart = x * to_b1 - y * to_b0 + row2.y * b.m[0] - row2.x * b.m[1];
    const Lanes<n> reach =
        abs(y) * a.h[0] + abs(x) * a.h[1] + abs(row2.y) * b.h[0] + abs(row2.x) * b.h[1];
    const Lanes<n> length = sqrt(x * x + y * y) * Lanes<n>::all(1 + 0x1p-18f) + least;
    const Lanes<n> by_product = (abs(apart) - reach - margin) / length;

    return gap_key(max(max(first, by_b * Lanes<n>::all(root_of_squares)), max(by_line, by_product)),
                   of_balls);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
