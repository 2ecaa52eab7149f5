#pragma once

#include <algorithm>
#include <cmath>

#include "core/overlap_figure8.h"

namespace scb {

/// How far an SCB reaches from its center in a direction at this cosine to its normal, see
/// extent(); never too little by more than rounding of the radius. The bound is that of
/// BasicPlacement. T is the scalar type, see BasicScb.
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

/// Separation by the exact extents of both SCBs along the normal of A, the normal of B, and the
/// line through the centers: the "effective radius of the intersection volume itself" of Section
/// 4's last paragraph. The balls are tested first. No threshold; five square roots at most.
template <class T>
Stage overlap_extents(const BasicScb<T>& a, const BasicScb<T>& b, const BasicPlacement<T>& placed) {
    using std::sqrt;
    const Vector3<T> c = transform_point(placed.b_to_a, b.c) - a.c;
    const T reach = a.r + b.r + placed.margin;
    const T squared_distance = squared_norm(c);
    if (squared_distance > reach * reach) return Stage::ball_ball;

    const Vector3<T> n = transform_direction(placed.b_to_a, b.n);
    const T cosine = dot(a.n, n);

    // Along n0, the signed distance of the point of B's axis that is in B says on which side of A's
    // slab B can be; likewise for A along n1.
    const T d0 = dot(a.n, c);
    const T from_a = d0 + (b.f > 0 ? b.f : b.e < 0 ? b.e : T(0)) * cosine;
    if (from_a > a.e) {
        if (d0 - reach_at_cosine(b, T(-cosine), placed.squared_sine_bound) > a.e + placed.margin)
            return Stage::slab_a;
    } else if (from_a < a.f) {
        if (d0 + reach_at_cosine(b, cosine, placed.squared_sine_bound) < a.f - placed.margin)
            return Stage::slab_a;
    }

    const T d1 = -dot(n, c);
    const T from_b = d1 + (a.f > 0 ? a.f : a.e < 0 ? a.e : T(0)) * cosine;
    if (from_b > b.e) {
        if (d1 - reach_at_cosine(a, T(-cosine), placed.squared_sine_bound) > b.e + placed.margin)
            return Stage::slab_b;
    } else if (from_b < b.f) {
        if (d1 + reach_at_cosine(a, cosine, placed.squared_sine_bound) < b.f - placed.margin)
            return Stage::slab_b;
    }

    // Along the line through the centers, where there is one; the sum of the extents may be
    // negative for slabs that leave their centers out.
    const T distance = sqrt(squared_distance);
    if (!(distance > placed.margin)) return Stage::overlapping;
    if (distance - placed.margin >
        reach_at_cosine(a, T(d0 / distance), placed.squared_sine_bound) +
            reach_at_cosine(b, T(d1 / distance), placed.squared_sine_bound))
        return Stage::center_line;
    return Stage::overlapping;
}

}  // namespace scb
