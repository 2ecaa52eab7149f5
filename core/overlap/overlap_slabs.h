#pragma once

#include "scb/placement.h"
#include "scb/scb.h"
#include "scb/stage.h"

namespace scb {

/// Distances of two slab cut balls along their normals, computed by overlap_slabs.
template <class T>
struct SlabDistances {
    T d0 = 0;      ///< signed distance of B's center from A's, along A's normal
    T d1 = 0;      ///< signed distance of A's center from B's, along B's normal
    T cosine = 0;  ///< of the two normals
};

/// The stages that Figure 8 (lines 2 to 11) and its symmetric form share: the balls, then each slab
/// against the other's ball. `found` is set if none of them rejects. `line_8_as_printed` compares
/// with the radius of the other ball, see Figure8Errata.
template <bool line_8_as_printed = false, class T>
Stage overlap_slabs(const BasicScb<T>& a, const BasicScb<T>& b, const BasicPlacement<T>& placed,
                    SlabDistances<T>& found) {
    const T reach_b = b.r + placed.margin;
    const Vector3<T> c = transform_point(placed.b_to_a, b.c) - a.c;
    const T sum = a.r + reach_b;
    if (squared_norm(c) > sum * sum) return Stage::ball_ball;

    const T d0 = dot(a.n, c);
    if ((d0 - a.e > reach_b) | (a.f - d0 > reach_b)) return Stage::slab_ball;

    const Vector3<T> n = transform_direction(placed.b_to_a, b.n);
    const T d1 = -dot(n, c);
    const T reach_a = a.r + placed.margin;
    if ((d1 - b.e > reach_a) | (b.f - d1 > (line_8_as_printed ? reach_b : reach_a)))
        return Stage::ball_slab;

    found = {d0, d1, dot(a.n, n)};
    return Stage::overlapping;
}

}  // namespace scb
