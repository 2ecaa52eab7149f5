#pragma once

#include "core/overlap_figure8.h"

namespace scb {

/// The symmetric form of Figure 8: slab against cylinder without distinguishing cases, and without
/// a threshold. A slab is its middle plane, at m along the normal, and half its thickness, h: the
/// cylinder about B with the slab's height reaches |h1 cos| + r1 |sin| from its middle, m1, along
/// A's normal. It rejects all that the corrected Figure 8 rejects, and its answer stays when A and
/// B are exchanged or (n, e, f) becomes (-n, -f, -e).
template <class T>
Stage overlap_symmetric(const BasicScb<T>& a, const BasicScb<T>& b,
                        const BasicPlacement<T>& placed) {
    using std::abs;
    const T reach_b = b.r + placed.margin;
    const Vector3<T> c = transform_point(placed.b_to_a, b.c) - a.c;
    const T reach = a.r + reach_b;
    if (squared_norm(c) > reach * reach) return Stage::ball_ball;

    const T d0 = dot(a.n, c);
    if ((d0 - a.e > reach_b) | (a.f - d0 > reach_b)) return Stage::slab_ball;

    const Vector3<T> n = transform_direction(placed.b_to_a, b.n);
    const T d1 = -dot(n, c);
    const T reach_a = a.r + placed.margin;
    if ((d1 - b.e > reach_a) | (b.f - d1 > reach_a)) return Stage::ball_slab;

    const T cosine = dot(a.n, n);
    const T squared_sine = placed.squared_sine_bound - cosine * cosine;
    const T middle_a = (a.e + a.f) / 2, half_a = (a.e - a.f) / 2;
    const T middle_b = (b.e + b.f) / 2, half_b = (b.e - b.f) / 2;
    const T tilt = abs(cosine);
    const T gap_a = abs(d0 + middle_b * cosine - middle_a) - half_a - half_b * tilt - placed.margin;
    if ((gap_a > 0) & (gap_a * gap_a > b.r * b.r * squared_sine)) return Stage::slab_cylinder;
    const T gap_b = abs(d1 + middle_a * cosine - middle_b) - half_b - half_a * tilt - placed.margin;
    if ((gap_b > 0) & (gap_b * gap_b > a.r * a.r * squared_sine)) return Stage::cylinder_slab;
    return Stage::overlapping;
}

}  // namespace scb
