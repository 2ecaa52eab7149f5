#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scb/scb2.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {

/// A number between `most` / 2 and `most`, times a power of two from 1 down to 2^(1 - powers).
inline double random_magnitude(Random& random, double most, std::uint32_t powers) {
    const double number = random.uniform(most / 2, most);
    return std::ldexp(number, -static_cast<int>(random.below(powers)));
}

/// A number of (0, 1], of all magnitudes down to 1e-8; now and then 0 or 1.
inline double random_share(Random& random) {
    switch (random.below(6)) {
        case 0:
            return 0;
        case 1:
            return 1;
        case 2:
            return random_magnitude(random, 1, 27);
        default:
            return random.uniform(0, 1);
    }
}

/// Radius about 1: flat ones, needles, points cut off, slabs that cut nothing.
inline Scb2 random_scb2(Random& random) {
    Scb2 s;
    s.c = random_point(random);
    s.r = random.uniform(0.1, 2);
    Mat3 axes = random_rotation(random);
    for (std::size_t i = 0; i < 2; ++i) {
        Vec3 n = axes.col(static_cast<int>(i));
        if (i == 1) n -= dot(s.slabs[0].n, n) * s.slabs[0].n;
        s.slabs[i].n = n / std::sqrt(squared_norm(n));
        s.slabs[i].e = s.r * random_share(random);
        s.slabs[i].f = -s.r * random_share(random) + 0.0;
    }
    // Once more, for what the first difference left.
    Vec3& n = s.slabs[1].n;
    n -= dot(s.slabs[0].n, n) * s.slabs[0].n;
    n /= std::sqrt(squared_norm(n));
    return s;
}

/// The point moved to the planes that it is beyond.
inline Vec3 pulled_into(const Scb2& s, Vec3 point) {
    for (const Slab& slab : s.slabs) {
        const double h = dot(slab.n, point - s.c);
        point += (std::clamp(h, slab.f, slab.e) - h) * slab.n;
    }
    return point;
}

/// A farthest point in a unit direction, from the center: by a search over the height along the
/// first normal, which what is left of each disc makes concave.
inline Vec3 farthest_point(const Scb2& s, const Vec3& d) {
    const Vec3 axes[3] = {s.slabs[0].n, s.slabs[1].n, long_axis(s)};
    const double a = dot(axes[0], d), b = dot(axes[1], d), c = dot(axes[2], d);
    const auto point_at = [&](double h) {
        const double radius = std::sqrt(std::max(0.0, (s.r - h) * (s.r + h)));
        const double length = std::hypot(b, c);
        const double y =
            std::clamp(length > 0 ? radius * b / length : 0.0, std::max(s.slabs[1].f, -radius),
                       std::min(s.slabs[1].e, radius));
        const double z = std::copysign(std::sqrt(std::max(0.0, (radius - y) * (radius + y))), c);
        return Vec3(h, y, z);
    };
    const auto value = [&](double h) {
        const Vec3 p = point_at(h);
        return a * p[0] + b * p[1] + c * p[2];
    };
    double lower = s.slabs[0].f, upper = s.slabs[0].e;
    for (int i = 0; i < 200; ++i) {
        const double third = (upper - lower) / 3;
        if (value(lower + third) < value(upper - third))
            lower += third;
        else
            upper -= third;
    }
    double best = lower;
    for (const double h : {upper, s.slabs[0].f, s.slabs[0].e})
        if (value(h) > value(best)) best = h;
    const Vec3 p = point_at(best);
    return p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
}

/// The same set of points: one normal reversed, and the slabs exchanged.
inline Scb2 flipped(Scb2 s) {
    std::swap(s.slabs[0], s.slabs[1]);
    Slab& slab = s.slabs[0];
    slab = {-slab.n, -slab.f, -slab.e};
    return s;
}

/// How a pair is drawn: what the frames are to each other, and whether both are needles.
struct Scb2PairFamily {
    enum class Frames { random, long_axes_nearly_parallel, nearly_parallel };

    std::string_view name;
    Frames frames;
    bool needles;
};

inline constexpr std::array<Scb2PairFamily, 6> scb2_pair_families = {{
    {"random", Scb2PairFamily::Frames::random, false},
    {"long axes parallel", Scb2PairFamily::Frames::long_axes_nearly_parallel, false},
    {"frames parallel", Scb2PairFamily::Frames::nearly_parallel, false},
    {"needles", Scb2PairFamily::Frames::random, true},
    {"needles, long axes parallel", Scb2PairFamily::Frames::long_axes_nearly_parallel, true},
    {"needles, frames parallel", Scb2PairFamily::Frames::nearly_parallel, true},
}};

/// Turns by about that angle, of all magnitudes from 1e-9 to 1; or not at all.
inline Mat3 slight_turn(Random& random, const Vec3& about) {
    const double angle = random.below(8) == 0 ? 0 : random_magnitude(random, 1, 31);
    const double s = angle / (1 + angle * angle / 4), c = std::sqrt(1 - s * s);
    Mat3 skew;
    skew << 0, -about[2], about[1], about[2], 0, -about[0], -about[1], about[0], 0;
    return Mat3::Identity() + s * skew + (1 - c) * skew * skew;
}

/// `axes` made unit vectors at right angles, to a few units in the last place.
inline void set_normals(Scb2& s, const Mat3& axes) {
    const Vec3 first = axes.col(0);
    s.slabs[0].n = first / std::sqrt(squared_norm(first));
    Vec3 n = axes.col(1);
    for (int i = 0; i < 2; ++i) {
        n -= dot(s.slabs[0].n, n) * s.slabs[0].n;
        n /= std::sqrt(squared_norm(n));
    }
    s.slabs[1].n = n;
}

/// Two whose distance is `gap`, in units of the larger radius, or that must be moved so far to come
/// apart (negative): the points that are farthest along and against a direction are put upon each
/// other, and B is moved along it. The direction is any, or nearly one of the normals, or nearly
/// the product of the long axes. Each in its own frame, `spread` times as far from the origin as
/// others.
inline VolumePair<Scb2> scb2_pair_at_gap(Random& random, const Scb2PairFamily& family, double gap,
                                         double spread = 1) {
    VolumePair<Scb2> pair{random_scb2(random), random_scb2(random), {}};
    Scb2 &a = pair.a, &b = pair.b;
    if (family.needles)
        for (Scb2* s : {&a, &b})
            for (Slab& slab : s->slabs) {
                slab.e *= std::ldexp(1, -static_cast<int>(random.below(12)));
                slab.f = slab.f * std::ldexp(1, -static_cast<int>(random.below(12))) + 0.0;
            }
    Mat3 axes;
    axes << a.slabs[0].n, a.slabs[1].n, long_axis(a);
    if (family.frames == Scb2PairFamily::Frames::long_axes_nearly_parallel) {
        const Mat3 turned = slight_turn(random, random_unit_vector(random)) * axes;
        const double angle = random.uniform(-1, 1), rest = std::sqrt(1 - angle * angle);
        Mat3 about = turned;
        about.col(0) = rest * turned.col(0) + angle * turned.col(1);
        about.col(1) = rest * turned.col(1) - angle * turned.col(0);
        set_normals(b, about);
    }
    if (family.frames == Scb2PairFamily::Frames::nearly_parallel)
        set_normals(b, slight_turn(random, random_unit_vector(random)) * axes);
    Vec3 d = random_unit_vector(random);
    const double tilt = 0.01 * random_share(random);
    switch (random.below(4)) {
        case 0:
            d = a.slabs[random.below(2)].n + tilt * d;
            break;
        case 1:
            d = b.slabs[random.below(2)].n + tilt * d;
            break;
        case 2: {
            const Vec3 product = cross(long_axis(a), long_axis(b));
            const double length = std::sqrt(squared_norm(product));
            if (length > 0) d = product / length + tilt * d;
            break;
        }
        default:
            break;
    }
    d /= std::sqrt(squared_norm(d));
    a.c *= spread;
    b.c = a.c + farthest_point(a, d) - farthest_point(b, -d) + gap * std::max(a.r, b.r) * d;
    Pose pose = random_pose(random);
    pose.translation *= spread;
    pair.b_to_a = pose;
    b = placed(b, inverse(pose));
    Mat3 own;
    own << b.slabs[0].n, b.slabs[1].n, long_axis(b);
    set_normals(b, own);
    return pair;
}

/// A pair near contact: 1e-8 to 0.1 of the larger radius apart, or into each other.
inline VolumePair<Scb2> random_scb2_pair(Random& random, const Scb2PairFamily& family) {
    const double size = random_magnitude(random, 0.1, 24);
    return scb2_pair_at_gap(random, family, random.below(2) == 0 ? size : -size);
}

}  // namespace scb
