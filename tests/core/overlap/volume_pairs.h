#pragma once

#include <cmath>

#include "core/volumes/any_volume.h"
#include "core/volumes/measured_shape.h"
#include "scb/pose.h"
#include "scb/scb.h"
#include "tests/core/fit/point_sets.h"

namespace scb {

/// Two volumes, each in its own frame, and where B is, seen from A's.
template <class V>
struct VolumePair {
    V a, b;
    Pose b_to_a;
};

inline Pose compose(const Pose& outer, const Pose& inner) {
    return {outer.rotation * inner.rotation, transform_point(outer, inner.translation)};
}

/// Made by operations that IEEE 754 fixes only, so that it is the same on every machine.
inline Mat3 random_rotation(Random& random) {
    // From a uniform unit quaternion.
    double w, x, y, z, squared;
    do {
        w = random.uniform(-1, 1);
        x = random.uniform(-1, 1);
        y = random.uniform(-1, 1);
        z = random.uniform(-1, 1);
        squared = w * w + x * x + y * y + z * z;
    } while (squared > 1 || squared < 0.01);
    const double s = 2 / squared;
    Mat3 rotation;
    rotation << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),
        s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), s * (x * z - w * y),
        s * (y * z + w * x), 1 - s * (x * x + y * y);
    return rotation;
}

inline Pose random_pose(Random& random, double reach = 1) {
    return {random_rotation(random), reach * random_point(random)};
}

/// The same set of points.
inline Scb flipped(const Scb& s) { return {s.c, s.r, -s.n, -s.f, -s.e}; }

/// The slab on the other side of the center.
inline Scb mirrored(const Scb& s) { return {s.c, s.r, s.n, -s.f, -s.e}; }

inline Scb scaled(Scb s, double factor) {
    s.c *= factor;
    s.r *= factor;
    s.e *= factor;
    s.f *= factor;
    return s;
}

/// A slab cut ball with the center at the origin and in its slab.
inline Scb random_centered_scb(Random& random, const Vec3& normal) {
    Scb s;
    s.r = random.uniform(0.25, 1);
    s.n = normal;
    s.e = s.r * random.uniform();
    s.f = -s.r * random.uniform();
    if (random.below(2) == 0) {
        s.e /= 8;
        s.f /= 8;
    }
    return s;
}

/// Draws a slab on either side of the center instead, no higher than the one that held it.
inline Scb with_center_left_out(Random& random, Scb s) {
    s.f = s.e * random.uniform();
    return random.below(2) == 0 ? mirrored(s) : s;
}

/// Of either kind; one in four has a slab that leaves the center out.
inline Scb random_scb(Random& random, const Vec3& normal) {
    const Scb s = random_centered_scb(random, normal);
    return random.below(4) == 0 ? with_center_left_out(random, s) : s;
}

/// Two slab cut balls of about unit size, each in a frame of its own, that overlap a little or are
/// apart a little. One third have random normals, one third nearly parallel, one third nearly
/// antiparallel ones.
inline VolumePair<Scb> random_scb_pair(Random& random) {
    const Vec3 n = random_unit_vector(random);
    const std::uint32_t kind = random.below(3);
    Vec3 m = kind == 0 ? random_unit_vector(random)
                       : Vec3((n + random.uniform(0, 0.3) * random_point(random)).normalized());
    if (kind == 2) m = -m;
    Scb a = random_scb(random, n), b = random_scb(random, m);
    Vec3 d = random_unit_vector(random);
    if (random.below(2) == 0) d = (random.below(2) == 0 ? 1 : -1) * n + 0.4 * d;
    d.normalize();
    a.c = random_point(random);
    b.c = a.c + random.uniform(0.3, 1.15) * (support(a, d) + support(b, -d)) * d;
    const Pose pose = random_pose(random);
    return {a, placed(b, inverse(pose)), pose};
}

}  // namespace scb
