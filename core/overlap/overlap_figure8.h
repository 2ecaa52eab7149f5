#pragma once

#include "core/overlap/overlap_slabs.h"

namespace scb {

/// The errors of Figure 8 that are kept.
struct Figure8Errata {
    bool line_8 = false;       ///< `d1 - f1 < -r1`, where it must be -r0: misses collisions
    bool lines_20_23 = false;  ///< the two calls are exchanged: they never reject
};

/// The conservative overlap test of Larsson and Akenine-Moller, "Bounding Volume Hierarchies of
/// Slab Cut Balls", Figure 8: the stage that rejected A and B, or overlapping. The cylinder tests
/// are made where |n0.n1| > threshold (the paper's a).
///
/// Equations 7 and 8 project the cylinder's top as a point. Here its distance along the other
/// normal is d + k cos(alpha), which is equal and cheaper. The four cases of the cylinder tests are
/// one, since the planes that face each other are selected first.
template <Figure8Errata errata, class T>
Stage overlap_figure8(const BasicScb<T>& a, const BasicScb<T>& b, const BasicPlacement<T>& placed,
                      const T& threshold) {
    SlabDistances<T> at;
    const Stage rejected = overlap_slabs<errata.line_8>(a, b, placed, at);
    if (rejected != Stage::overlapping) return rejected;

    const auto& [d0, d1, cosine] = at;
    const bool opposed = cosine < -threshold;
    if (!opposed & !(cosine > threshold)) return Stage::overlapping;
    // B is on this side of A, and this plane of B faces A.
    const bool above = d0 > 0;
    const bool top = above == opposed;
    const T squared_sine = placed.squared_sine_bound - cosine * cosine;
    const T plane_a = above ? a.e : a.f;
    const T plane_b = top ? b.e : b.f;
    const T off_a = d0 + plane_b * cosine - plane_a;
    const T gap_a = (above ? off_a : -off_a) - placed.margin;
    if ((gap_a > 0) & (gap_a * gap_a > b.r * b.r * squared_sine)) return Stage::slab_cylinder;

    const bool exchanged = errata.lines_20_23 && !opposed;
    const T other_a = exchanged ? (above ? a.f : a.e) : plane_a;
    const T other_b = exchanged ? (top ? b.f : b.e) : plane_b;
    const T off_b = d1 + other_a * cosine - other_b;
    const T gap_b = ((top != exchanged) ? off_b : -off_b) - placed.margin;
    if ((gap_b > 0) & (gap_b * gap_b > a.r * a.r * squared_sine)) return Stage::cylinder_slab;
    return Stage::overlapping;
}

}  // namespace scb
