#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "scb/scb.h"
#include "scb/scb2.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {

// Slab cut balls of any place and thickness, and points in them.

inline Scb some_scb(Random& random, double size) {
    Scb scb;
    scb.c = size * random_point(random);
    scb.r = size * random.uniform(0.01, 1);
    scb.n = random_unit_vector(random);
    // Thin ones too.
    const double thin = random.below(2) == 0 ? 1 : 1e-5;
    scb.e = thin * scb.r * random.uniform();
    scb.f = -thin * scb.r * random.uniform();
    return scb;
}

inline Scb2 some_scb2(Random& random, double size) {
    const Scb one = some_scb(random, size);
    Vec3 second = cross(one.n, random_unit_vector(random));
    second /= std::sqrt(squared_norm(second));
    const double thin = random.below(3) == 0 ? 1e-5 : 1;
    Scb2 scb{one.c,
             one.r,
             {Slab{one.n, one.e, one.f},
              Slab{second, thin * one.r * random.uniform(), -thin * one.r * random.uniform()}}};
    if (random.below(2) == 0) std::swap(scb.slabs[0], scb.slabs[1]);
    return scb;
}
template <class V>
V some_volume(Random& random, double size) {
    if constexpr (std::is_same_v<V, Scb>)
        return some_scb(random, size);
    else
        return some_scb2(random, size);
}

inline double height_in(const Slab& slab, Random& random) {
    return random.below(3) == 0   ? slab.e
           : random.below(2) == 0 ? slab.f
                                  : slab.f + (slab.e - slab.f) * random.uniform();
}

/// A point in the volume, most often on its surface.
inline Vec3 point_of(const Scb& scb, Random& random) {
    const double along = height_in({scb.n, scb.e, scb.f}, random);
    Vec3 side = cross(scb.n, random_unit_vector(random));
    side /= std::sqrt(squared_norm(side));
    const double far = std::sqrt(std::max(0.0, scb.r * scb.r - along * along));
    return scb.c + along * scb.n + (1 - 1e-15) * far * side;
}
inline Vec3 point_of(const Scb2& scb, Random& random) {
    const auto& [first, second] = scb.slabs;
    double along = height_in(first, random), across = height_in(second, random);
    const double most = std::sqrt(along * along + across * across);
    if (most > scb.r) {
        along *= scb.r / most;
        across *= scb.r / most;
    }
    const double far = std::sqrt(std::max(0.0, scb.r * scb.r - along * along - across * across));
    return scb.c + along * first.n + across * second.n +
           (1 - 1e-15) * (random.below(2) == 0 ? far : -far) * long_axis(scb);
}

}  // namespace scb
