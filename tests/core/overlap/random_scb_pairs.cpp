#include "tests/core/overlap/random_scb_pairs.h"

#include <algorithm>
#include <cmath>

// Every number is drawn in a statement of its own, or before what else an expression draws: the
// order in which operands and arguments are evaluated is the compiler's.

namespace scb {
namespace {

using Normals = ScbPairFamily::Normals;

Vec3 unit(const Vec3& v) { return v / std::sqrt(squared_norm(v)); }

Vec3 random_tilt(Random& random, const Vec3& direction, double tangent) {
    const Vec3 across = unit(cross(direction, random_unit_vector(random)));
    return unit(direction + tangent * across);
}

Vec3 random_normal(Random& random, const Vec3& other, Normals normals) {
    if (normals == Normals::random) return random_unit_vector(random);
    const Vec3 n = random_tilt(random, other, log_uniform(random, 1e-9, 1));
    return normals == Normals::nearly_parallel ? n : Vec3(-n);
}

Scb random_shape(Random& random, double r, bool centered) {
    Scb s;
    s.c = random_point(random);
    s.r = r;
    const double tau = random.below(8) == 0 ? 0 : log_uniform(random, 1e-12, 2) * r;
    s.f = centered ? -tau * random.uniform() : r * random.uniform();
    s.e = std::min(s.f + tau, r);
    s.f = std::max(s.f, -r);
    return !centered && random.below(2) == 0 ? mirrored(s) : s;
}

double rim_radius(const Scb& s, double k) { return std::sqrt((s.r - k) * (s.r + k)); }

// A farthest point, from c.
Vec3 random_support(Random& random, const Scb& s, const Vec3& d) {
    const double cosine = dot(s.n, d), k = std::clamp(s.r * cosine, s.f, s.e);
    if (k == s.r * cosine && std::abs(k) < s.r) return s.r * d;
    const Vec3 across = d - cosine * s.n;
    if (squared_norm(across) < 1e-30) {
        const Vec3 level = unit(cross(s.n, random_unit_vector(random)));
        return k * s.n + rim_radius(s, k) * std::sqrt(random.uniform()) * level;
    }
    // The difference has few digits where d is nearly n; only its part along n would matter.
    const Vec3 level = across - dot(s.n, across) * s.n;
    return k * s.n + rim_radius(s, k) * unit(level);
}

Vec3 contact_direction(Random& random, const Scb& a, const Scb& b) {
    const double side = random.below(2) == 0 ? 1 : -1;
    switch (random.below(5)) {
        case 0:
            return side * a.n;
        case 1:
            return side * b.n;
        case 2: {
            const Vec3 n = side * (random.below(2) == 0 ? a.n : b.n);
            return random_tilt(random, n, log_uniform(random, 1e-9, 1));
        }
        case 3: {
            // About as far from both normals as they are from each other.
            const Vec3 b_n = dot(a.n, b.n) < 0 ? Vec3(-b.n) : b.n;
            const double along = random.uniform(), across = random.uniform();
            return side * unit(a.n + along * (b_n - a.n) + across * cross(a.n, b_n));
        }
        default:
            return random_unit_vector(random);
    }
}

struct Bodies {
    Scb a, b;
};

// The shapes and normals; B is not yet placed.
Bodies random_bodies(Random& random, const ScbPairFamily& family) {
    // The larger radius is about 1.
    const double larger = random.uniform(0.5, 1), smaller = larger * log_uniform(random, 1e-3, 1);
    const bool a_is_larger = random.below(2) == 0;
    Bodies bodies;
    bodies.a = random_shape(random, a_is_larger ? larger : smaller, family.centered);
    bodies.a.n = random_unit_vector(random);
    bodies.b = random_shape(random, a_is_larger ? smaller : larger, family.centered);
    bodies.b.n = random_normal(random, bodies.a.n, family.normals);
    return bodies;
}

// Puts the center of B at the offset from A's center, and B into a frame of its own.
ScbPair framed(Random& random, const Bodies& bodies, const Vec3& offset, double gap,
               double spread = 1) {
    ScbPair pair;
    pair.a = bodies.a;
    Scb b = bodies.b;
    b.c = bodies.a.c + offset;
    pair.b_to_a = random_pose(random, 2);
    pair.b_to_a.translation *= spread;
    pair.b = placed(b, inverse(pair.b_to_a));
    pair.gap = gap;
    return pair;
}

ScbPair at_contact(Random& random, const Bodies& bodies, double gap, double spread = 1) {
    const Vec3 d = contact_direction(random, bodies.a, bodies.b),
               on_a = random_support(random, bodies.a, d),
               on_b = random_support(random, bodies.b, -d);
    return framed(random, bodies, on_a - on_b + gap * d, gap, spread);
}

}  // namespace

double log_uniform(Random& random, double lower, double upper) {
    std::uint32_t octaves = 0;
    for (double x = lower; x < upper; x *= 2) ++octaves;
    const int octave = static_cast<int>(random.below(std::max(octaves, 1u)));
    return std::min(std::ldexp(lower, octave) * random.uniform(1, 2), upper);
}

ScbPair random_scb_pair(Random& random, const ScbPairFamily& family) {
    const Bodies bodies = random_bodies(random, family);
    const double larger = std::max(bodies.a.r, bodies.b.r),
                 smaller = std::min(bodies.a.r, bodies.b.r);
    if (family.near_contact) {
        const double distance = log_uniform(random, 1e-9 * larger, 0.1 * smaller);
        return at_contact(random, bodies, random.below(2) == 0 ? distance : -distance);
    }
    // Uniform in the ball of the centers whose balls meet.
    Vec3 offset;
    do offset = random_point(random);
    while (squared_norm(offset) > 1);
    return framed(random, bodies, (larger + smaller) * offset, 0);
}

ScbPair scb_pair_at_gap(Random& random, const ScbPairFamily& family, double gap) {
    const Bodies bodies = random_bodies(random, family);
    return at_contact(random, bodies, gap * std::max(bodies.a.r, bodies.b.r));
}

ScbPair touching_scb_pair(Random& random, const ScbPairFamily& family, double spread) {
    Bodies bodies = random_bodies(random, family);
    bodies.a.c *= spread;
    return at_contact(random, bodies, 0, spread);
}

}  // namespace scb
