#pragma once

#include <cmath>

#include "scb/vec.h"

namespace scb {

/// A and B, slab cut balls of one type, relative to A's center.
template <class V>
struct CenteredPair {
    V a, b;

    CenteredPair(const V& of_a, const V& of_b) : a(of_a), b(of_b) {
        b.c -= a.c;
        a.c = Vec3::Zero();
    }
    Vec3 to_b() const { return b.c; }
    CenteredPair exchanged() const { return {b, a}; }
};

/// The best separating direction so far. `reach(volume, d)` is how far a volume reaches from its
/// center along the unit vector d.
template <class V, double (*reach)(const V&, const Vec3&)>
struct Separation {
    const CenteredPair<V>& pair;
    Vec3 direction = Vec3::Zero();
    double gap = -HUGE_VAL;

    void try_direction(const Vec3& d) {
        const double length = std::sqrt(squared_norm(d));
        if (!(length > 0 && std::isfinite(length))) return;
        const Vec3 unit = d / length;
        const double g = dot(unit, pair.to_b()) - reach(pair.a, unit) - reach(pair.b, Vec3(-unit));
        if (g > gap) {
            gap = g;
            direction = unit;
        }
    }
    void try_both_ways(const Vec3& d) {
        try_direction(d);
        try_direction(-d);
    }
};

}  // namespace scb
