#pragma once

#include <algorithm>
#include <cmath>

#include "scb/placement.h"
#include "scb/scb.h"
#include "scb/stage.h"

namespace scb {

/// The extent of an SCB from its center in a direction at this cosine to its normal, see support();
/// too small by rounding of the radius at most. The bound is BasicPlacement::squared_sine_bound. T
/// is the scalar type, see BasicScb.
template <class T>
T reach_at_cosine(const BasicScb<T>& s, const T& cosine, const T& squared_sine_bound) {
    using std::max;
    using std::sqrt;
    const T h = s.r * cosine;
    if ((s.f <= h) & (h <= s.e)) return s.r;
    const T k = h > s.e ? s.e : s.f;
    return k * cosine +
           sqrt(max(T(0), (s.r - k) * (s.r + k)) * max(T(0), squared_sine_bound - cosine * cosine));
}

/// Whether all of `other` is beyond one of the planes of `s`, by its exact extent along the normal
/// of `s`. `d` is the signed distance of its center along this normal, from the center of `s`.
template <class T>
bool is_beyond_slab(const BasicScb<T>& s, const BasicScb<T>& other, const T& d, const T& cosine,
                    const BasicPlacement<T>& placed) {
    // The point of its axis that is nearest to its center and inside its slab decides on which side
    // it can be.
    const T axis_point = d + (other.f > 0 ? other.f : other.e < 0 ? other.e : T(0)) * cosine;
    if (axis_point > s.e)
        return d - reach_at_cosine(other, T(-cosine), placed.squared_sine_bound) >
               s.e + placed.margin;
    if (axis_point < s.f)
        return d + reach_at_cosine(other, cosine, placed.squared_sine_bound) < s.f - placed.margin;
    return false;
}

/// Separation by the exact extents of both SCBs along the normal of A, the normal of B, and the
/// line through the centers: the "effective radius of the intersection volume itself" of the last
/// paragraph of Section 4. The balls are tested first. No threshold; at most five square roots.
template <class T>
Stage overlap_extents(const BasicScb<T>& a, const BasicScb<T>& b, const BasicPlacement<T>& placed) {
    using std::sqrt;
    const Vector3<T> c = transform_point(placed.b_to_a, b.c) - a.c;
    const T sum = a.r + b.r + placed.margin;
    const T squared_distance = squared_norm(c);
    if (squared_distance > sum * sum) return Stage::ball_ball;

    const Vector3<T> n = transform_direction(placed.b_to_a, b.n);
    const T cosine = dot(a.n, n);

    const T d0 = dot(a.n, c);
    if (is_beyond_slab(a, b, d0, cosine, placed)) return Stage::slab_a;
    const T d1 = -dot(n, c);
    if (is_beyond_slab(b, a, d1, cosine, placed)) return Stage::slab_b;

    // Along the line through the centers, if they differ. The sum of the extents may be negative if
    // slabs do not contain their centers.
    const T distance = sqrt(squared_distance);
    if (!(distance > placed.margin)) return Stage::overlapping;
    if (distance - placed.margin >
        reach_at_cosine(a, T(d0 / distance), placed.squared_sine_bound) +
            reach_at_cosine(b, T(d1 / distance), placed.squared_sine_bound))
        return Stage::center_line;
    return Stage::overlapping;
}

}  // namespace scb
