#pragma once

#include "core/overlap/overlap_slabs.h"

namespace scb {

/// The symmetric form of Figure 8: slab against cylinder without distinguishing cases, and without
/// a threshold. A slab is its middle plane, at m along the normal, and half its thickness, h: the
/// cylinder about B with the slab's height reaches |h1 cos| + r1 |sin| from its middle, m1, along
/// A's normal. It rejects all that the corrected Figure 8 rejects, and its result does not change
/// when A and B are exchanged, or (n, e, f) becomes (-n, -f, -e).
template <class T>
Stage overlap_symmetric(const BasicScb<T>& a, const BasicScb<T>& b,
                        const BasicPlacement<T>& placed) {
    using std::abs;
    SlabDistances<T> at;
    const Stage rejected = overlap_slabs<>(a, b, placed, at);
    if (rejected != Stage::overlapping) return rejected;

    const auto& [d0, d1, cosine] = at;
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
