// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_LANE_SIGNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_LANE_SIGNS_INL_H_
#undef SCB_CORE_LANE_SIGNS_INL_H_
#else
#define SCB_CORE_LANE_SIGNS_INL_H_
#endif

#include "core/base/double_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

using DoubleMask = LaneMask<static_cast<int>(double_lanes), double>;

/// The signs of numbers.
struct LaneSigns {
    Doubles value;      ///< has the sign where it is certain, else 0
    DoubleMask unsure;  ///< lanes whose sign is not certain
};

/// The signs of a sum of products. Each factor is a difference of two coordinates, rounded once.
/// `permanent`: the same sum with all terms positive. `relative`: a bound of the error over the
/// permanent, as in orientation.h. Nothing may underflow, see `underflows`: then a permanent of 0
/// means that each term has a factor of exactly 0. After an overflow, no sign is certain.
HWY_INLINE LaneSigns signs_of(Doubles sum, Doubles permanent, double relative) {
    const Doubles zero = Doubles::all(0);
    // Comparisons that are false for NaN, and for two infinities.
    const DoubleMask small = !(permanent * Doubles::all(relative) < abs(sum));
    return {select(small, zero, sum), small & !(permanent == zero)};
}

/// The least and the greatest of some signs, where all are certain; unsure ones count as 0.
struct SignRange {
    Doubles least, greatest;
    DoubleMask unsure;

    HWY_INLINE SignRange(const LaneSigns& a, const LaneSigns& b)
        : least(min(a.value, b.value)),
          greatest(max(a.value, b.value)),
          unsure(a.unsure | b.unsure) {}
    HWY_INLINE SignRange(const LaneSigns& a, const LaneSigns& b, const LaneSigns& c)
        : least(min(min(a.value, b.value), c.value)),
          greatest(max(max(a.value, b.value), c.value)),
          unsure(a.unsure | b.unsure | c.unsure) {}

    /// All are positive, or all negative.
    HWY_INLINE DoubleMask one_sign() const {
        return (Doubles::all(0) < least) | (greatest < Doubles::all(0));
    }
    /// All are certain, and none is positive, or none negative.
    HWY_INLINE DoubleMask not_both() const {
        return ((Doubles::all(0) <= least) | (greatest <= Doubles::all(0))) & !unsure;
    }
    /// Some are positive and some negative.
    HWY_INLINE DoubleMask both() const {
        return (least < Doubles::all(0)) & (Doubles::all(0) < greatest);
    }
    /// All are 0.
    HWY_INLINE DoubleMask all_zero() const { return (least == greatest) & !(unsure | one_sign()); }
    /// Some are certain and not 0.
    HWY_INLINE DoubleMask some_sign() const { return (least < greatest) | one_sign(); }
};

/// The plane of a triangle, for the signs of determinants: PlaneFilter in lanes, for coordinates
/// whose products do not underflow.
struct LanePlane {
    Doubles3 normal, magnitude;

    /// `u` and `v`: two edges of the triangle, or any two vectors.
    HWY_INLINE LanePlane(Doubles3 u, Doubles3 v)
        : normal(cross(u, v)),
          magnitude{abs(u.y * v.z) + abs(u.z * v.y), abs(u.z * v.x) + abs(u.x * v.z),
                    abs(u.x * v.y) + abs(u.y * v.x)} {}

    /// The signs of det(u, v, w): the side on which a point is, `w` from a corner.
    HWY_INLINE LaneSigns side(Doubles3 w) const {
        return signs_of(dot(normal, w), dot(magnitude, {abs(w.x), abs(w.y), abs(w.z)}),
                        10 * 0x1p-53);
    }
};

/// Two coordinates in lanes.
struct Doubles2 {
    Doubles x, y;

    friend HWY_INLINE Doubles2 operator-(Doubles2 a, Doubles2 b) { return {a.x - b.x, a.y - b.y}; }
};

/// The signs of u.x v.y - u.y v.x: 1 where v is counterclockwise of u.
HWY_INLINE LaneSigns turn(Doubles2 u, Doubles2 v) {
    const Doubles left = u.x * v.y, right = u.y * v.x;
    return signs_of(left - right, abs(left) + abs(right), 6 * 0x1p-53);
}

/// The least magnitude of the coordinates that are not 0, and of `least`.
HWY_INLINE Doubles smallest_magnitude(Doubles least, Doubles3 p) {
    const Doubles zero = Doubles::all(0);
    for (const Doubles x : {p.x, p.y, p.z}) least = min(least, select(x == zero, least, abs(x)));
    return least;
}

/// Lanes in which products of three differences of coordinates may underflow, by the least
/// magnitude of the coordinates that are not 0. Coordinates of 2^-200 and more are multiples of
/// 2^-252, so differences are 0 or at least that. Differences of two products of them are 0 or at
/// least 2^-557, and these times a difference at least 2^-809.
HWY_INLINE DoubleMask underflows(Doubles least) { return least < Doubles::all(0x1p-200); }

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
