#pragma once

#include <cmath>

#include "core/volumes/shape.h"

namespace scb {

// Functions that measures need beside area, volume and `contains`. All follow from `support`, so
// they exist for any type. Overloads for some types give tighter results.

/// The origin of `support`.
template <Volume V>
Vec3 support_center(const V& v) {
    if constexpr (ConvexVolume<V>)
        return center(v);
    else if constexpr (requires { v.center; })
        return v.center;
    else
        return v.c;
}

/// Two unit vectors at right angles to a unit vector and to each other, as the columns 1 and 2; it
/// is column 0.
inline Mat3 axes_along(const Vec3& n) {
    int shortest = 0;
    n.cwiseAbs().minCoeff(&shortest);
    const Vec3 side = cross(n, Vec3(Vec3::Unit(shortest)));
    Mat3 axes;
    axes.col(0) = n;
    axes.col(1) = side / std::sqrt(squared_norm(side));
    axes.col(2) = cross(n, Vec3(axes.col(1)));
    return axes;
}

/// Axes along which a box about the volume is small.
template <Volume V>
Mat3 box_axes_of(const V&) {
    return Mat3::Identity();
}
inline Mat3 box_axes_of(const Obb& box) { return box.axes; }
inline Mat3 box_axes_of(const Scb& scb) { return axes_along(scb.n); }
inline Mat3 box_axes_of(const Scb2& scb) {
    Mat3 axes;
    axes << scb.slabs[0].n, scb.slabs[1].n, long_axis(scb);
    return axes;
}

/// The smallest box along these axes that contains the volume.
template <Volume V>
Obb box_about(const V& v) {
    Obb box{support_center(v), box_axes_of(v), Vec3::Zero()};
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = box.axes.col(i);
        const double up = support(v, axis), down = support(v, Vec3(-axis));
        box.center += axis * ((up - down) / 2);
        box.half[i] = (up + down) / 2;
    }
    return box;
}

/// The volume with all its faces moved outward, so that rounding does not decide which points a
/// flat volume contains. A convex volume without an overload stays as it is.
template <ConvexVolume V>
V enlarged(const V& v, double) {
    return v;
}
inline Capsule enlarged(Capsule capsule, double by) {
    capsule.radius += by;
    return capsule;
}
inline Rss enlarged(Rss rss, double by) {
    rss.radius += by;
    return rss;
}
template <int k>
KDop<k> enlarged(KDop<k> dop, double by) {
    for (std::size_t i = 0; i < dop.which.size(); ++i) {
        const auto& d = dop_directions[static_cast<std::size_t>(dop.which[i])];
        const double moved = by * std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        dop.lower[i] -= moved;
        dop.upper[i] += moved;
    }
    return dop;
}
template <bool exact>
BasicAabb<exact> enlarged(BasicAabb<exact> box, double by) {
    box.half.array() += by;
    return box;
}
inline Ball enlarged(Ball ball, double by) {
    ball.radius += by;
    return ball;
}
inline Obb enlarged(Obb box, double by) {
    box.half.array() += by;
    return box;
}
inline Scb enlarged(Scb scb, double by) {
    scb.r += by;
    scb.e += by;
    scb.f -= by;
    return scb;
}
inline Scb2 enlarged(Scb2 scb, double by) {
    scb.r += by;
    for (Slab& slab : scb.slabs) {
        slab.e += by;
        slab.f -= by;
    }
    return scb;
}

/// The least value in [0, 1] of a convex function, by golden sections. Ends early at any value
/// below 0.
template <class Value>
double least_of(Value&& value) {
    constexpr double golden = 0.61803398874989484820;
    double lower = 0, upper = 1, a = upper - golden, b = golden;
    double at_a = value(a), at_b = value(b);
    for (int i = 0; i < 24 && at_a >= 0 && at_b >= 0; ++i) {
        if (at_a < at_b) {
            upper = b;
            b = a;
            at_b = at_a;
            a = upper - golden * (upper - lower);
            at_a = value(a);
        } else {
            lower = a;
            a = b;
            at_a = at_b;
            b = lower + golden * (upper - lower);
            at_b = value(b);
        }
    }
    return at_a < at_b ? at_a : at_b;
}

/// Whether the line meets a k-DOP: its slabs clip the line.
template <int k>
bool line_meets(const KDop<k>& dop, const Vec3& point, const Vec3& along) {
    double from = -HUGE_VAL, to = HUGE_VAL;
    for (std::size_t i = 0; i < dop.which.size(); ++i) {
        const auto& of = dop_directions[static_cast<std::size_t>(dop.which[i])];
        const Vec3 d(of[0], of[1], of[2]);
        const double at = dot(d, point), slope = dot(d, along);
        if (slope == 0) {
            if (at < dop.lower[i] || at > dop.upper[i]) return false;
            continue;
        }
        const double first = (dop.lower[i] - at) / slope, second = (dop.upper[i] - at) / slope;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    return from <= to;
}

/// Whether the line through `point` along a unit vector meets the volume; may be wrong for lines
/// that pass it by less than some 1e-5 of its size. Projected along the line, the volume is a
/// convex region. The line misses it if a direction across the line separates the two. Such a
/// direction has a positive part toward the line. Along the two edges of the diamond that these
/// directions span, the distance that the region reaches beyond the line is convex.
template <Volume V>
bool line_meets(const V& v, const Vec3& point, const Vec3& along) {
    const Vec3 center = support_center(v), from_center = point - center;
    const Vec3 nearest = from_center - along * dot(along, from_center);
    if (contains(v, Vec3(center + nearest))) return true;
    const double distance = std::sqrt(squared_norm(nearest));
    if (!(distance > 0)) return false;
    const Vec3 toward = nearest / distance, across = cross(along, toward);
    if (support(v, toward) < distance) return false;
    for (const double sign : {1.0, -1.0})
        if (least_of([&](double t) {
                const Vec3 direction = toward * (1 - t) + across * (sign * t);
                const double length = std::sqrt(squared_norm(direction));
                return length * support(v, Vec3(direction / length)) - (1 - t) * distance;
            }) < 0)
            return false;
    return true;
}

}  // namespace scb
