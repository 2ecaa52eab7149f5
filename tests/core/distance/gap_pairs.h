#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <vector>

#include "core/distance/volume_gap.h"
#include "tests/core/overlap/convex_pairs.h"
#include "tests/core/overlap/scb2_pairs.h"

// Pairs of volumes at a known distance: two points that are farthest along a direction are put
// opposite each other. Any two convex volumes that are apart are such a pair.
namespace scb {

/// A power of ten from 10^lower to 10^upper, and what is between.
inline double random_power(Random& random, double lower, double upper) {
    return std::pow(10, random.uniform(lower, upper));
}

/// A volume of about this size at a place: flat ones, needles and points too.
template <class V>
V drawn_volume(Random& random, const Vec3& center, double size) {
    const auto side = [&] { return size * random_share(random); };
    const Mat3 axes = random.below(3) == 0 ? Mat3(Mat3::Identity()) : random_rotation(random);
    V v;
    if constexpr (std::same_as<V, Scb>) {
        v = {center, size, axes.col(2), size * random_share(random), -size * random_share(random)};
        if (random.below(4) == 0) v = with_center_left_out(random, v);
    } else if constexpr (std::same_as<V, Scb2>) {
        v = random_scb2(random);
        const double scale = size / v.r;
        v.c = center;
        v.r *= scale;
        const auto narrowed = [&] {
            return random.below(3) == 0 ? random_magnitude(random, 1, 12) : 1.0;
        };
        for (Slab& slab : v.slabs) {
            slab.e *= scale * narrowed();
            slab.f *= scale * narrowed();
            slab.e = std::min(slab.e, v.r);
            slab.f = std::max(slab.f, -v.r);
        }
    } else if constexpr (std::same_as<V, Ball>) {
        v = {center, side()};
    } else if constexpr (std::same_as<V, Obb>) {
        v = {center, axes, Vec3(side(), side(), side())};
    } else if constexpr (requires { v.half_sides; }) {
        v.center = center;
        v.half_sides[0] = side() * axes.col(0);
        v.half_sides[1] = side() * axes.col(1);
        v.radius = side();
    } else if constexpr (requires { v.half_axis; }) {
        v.center = center;
        v.half_axis = side() * axes.col(0);
        v.radius = side();
    } else if constexpr (requires { V::which; }) {
        const Vec3 sides(side(), side(), side());
        std::vector<Vec3> points;
        for (std::uint32_t count = 1 + random.below(12); points.size() < count;)
            points.push_back(center + rotate(axes, Vec3(random_point(random).cwiseProduct(sides))));
        v = fitted<V>(points);
    } else {
        v.center = center;
        v.half = Vec3(side(), side(), side());
    }
    return v;
}

/// Of sides along a direction and against it, one end; of sides beside it, any point.
inline Vec3 far_along(Random& random, const Vec3& side, const Vec3& direction) {
    const double along = dot(side, direction);
    if (along * along <= 0x1p-90 * squared_norm(side)) return random.uniform(-1, 1) * side;
    return along < 0 ? Vec3(-side) : side;
}

/// A farthest point along a unit direction, up to rounding.
inline Vec3 drawn_far_point(Random&, const Ball& ball, const Vec3& direction) {
    return ball.center + ball.radius * direction;
}
inline Vec3 drawn_far_point(Random& random, const Scb& v, const Vec3& direction) {
    const double height = v.r * dot(v.n, direction), at = std::clamp(height, v.f, v.e);
    if (at == height) return v.c + v.r * direction;
    Vec3 beside = direction - dot(v.n, direction) * v.n;
    beside -= dot(v.n, beside) * v.n;
    double share = 1;
    if (squared_norm(beside) < 0x1p-90) {  // any point of the disc
        beside = cross(v.n, random_unit_vector(random));
        share = random.uniform();
    }
    const double rim = std::sqrt(std::max(0.0, (v.r - at) * (v.r + at)));
    return v.c + at * v.n + share * rim * unit_or_zero(beside);
}
inline Vec3 drawn_far_point(Random&, const Scb2& v, const Vec3& direction) {
    return v.c + farthest_point(v, direction);
}
inline Vec3 drawn_far_point(Random& random, const Obb& box, const Vec3& direction) {
    Vec3 p = box.center;
    for (int k = 0; k < 3; ++k)
        p += far_along(random, Vec3(box.half[k] * box.axes.col(k)), direction);
    return p;
}
template <bool exact>
Vec3 drawn_far_point(Random& random, const BasicAabb<exact>& box, const Vec3& direction) {
    return drawn_far_point(random, Obb{box.center, Mat3::Identity(), box.half}, direction);
}
inline Vec3 drawn_far_point(Random& random, const Rss& v, const Vec3& direction) {
    return v.center + far_along(random, v.half_sides[0], direction) +
           far_along(random, v.half_sides[1], direction) + v.radius * direction;
}
inline Vec3 drawn_far_point(Random& random, const Capsule& v, const Vec3& direction) {
    return v.center + far_along(random, v.half_axis, direction) + v.radius * direction;
}
template <int k>
Vec3 drawn_far_point(Random& random, const KDop<k>& v, const Vec3& direction) {
    const Vec3 corner = farthest_corner(slabs_of(v), direction);
    if (random.below(3) != 0) return corner;
    // Of a face or an edge that the direction is normal to, a point inside.
    const Vec3 other =
        farthest_corner(slabs_of(v), direction + 0x1p-46 * random_unit_vector(random));
    return corner + random.uniform() * (other - corner);
}

/// Directions in which gaps are measured, and others; exactly or nearly.
template <class V>
Vec3 drawn_direction(Random& random, const V& a, const V& b, const Mat3& rotation) {
    const Vec3 any = random_unit_vector(random);
    const auto one_of = [&](const std::array<Vec3, 3>& frame) { return frame[random.below(3)]; };
    Vec3 direction = any;
    switch (random.below(5)) {
        case 0:
            direction = one_of(thin_frame(a, any));
            break;
        case 1:
            direction = rotate(rotation, one_of(thin_frame(b, any)));
            break;
        case 2:
            if constexpr (has_long_direction<V>)
                direction = unit_or_zero(
                    cross(long_direction(a), rotate(rotation, Vec3(long_direction(b)))));
            if constexpr (requires { V::which; }) {
                const auto& d = dop_directions[static_cast<std::size_t>(
                    V::which[random.below(static_cast<std::uint32_t>(V::which.size()))])];
                direction = unit_or_zero(Vec3(d[0], d[1], d[2]));
                if (random.below(2) == 0) direction = rotate(rotation, direction);
            }
            break;
        default:
            break;
    }
    if (random.below(2) == 0) direction += random_power(random, -12, -1) * any;
    const Vec3 unit = unit_or_zero(direction);
    const Vec3 result = squared_norm(unit) > 0 ? unit : any;
    return random.below(2) == 0 ? result : Vec3(-result);
}

/// Any, none, or one that makes the frames of the volumes parallel up to a small angle. One in
/// eight is rigid to 1e-10 only.
template <class V>
Mat3 drawn_rotation(Random& random, const V& a, const V& b) {
    Mat3 rotation = random_rotation(random);
    const std::uint32_t kind = random.below(4);
    if (kind == 0) rotation = Mat3::Identity();
    if (kind == 1) {
        const Vec3 any = random_unit_vector(random);
        const auto of_a = thin_frame(a, any), of_b = thin_frame(b, any);
        if (squared_norm(of_a[2]) > 0 && squared_norm(of_b[2]) > 0) {
            Mat3 to, from;
            to << of_a[0], of_a[1], of_a[2];
            from << of_b[0], of_b[1], of_b[2];
            rotation = slight_turn(random, any) * (to * from.transpose());
        }
    }
    if (random.below(8) == 0)
        for (int k = 0; k < 3; ++k) rotation.col(k) += 1e-10 * random_point(random);
    return rotation;
}

/// Two volumes, and a point of each, between which the distance was drawn.
template <class V>
struct GapPair {
    V a, b;
    Pose b_to_a;
    Vec3 point_a, point_b;  ///< up to rounding; each in its own frame
    double gap = 0;
};

/// Sizes from 1e-3 to 1e3, one at most a thousand times as large as the other; on the origins and
/// far from them; from touching to a hundred sizes apart.
template <class V>
GapPair<V> drawn_gap_pair(Random& random) {
    const double size = random_power(random, -3, 3);
    const auto volume = [&] {
        const double own = size * (random.below(2) == 0 ? 1 : random_power(random, -3, 0)),
                     away = size * (random.below(3) == 0   ? random_power(random, 0, 4)
                                    : random.below(2) == 0 ? 1
                                                           : 0);
        return drawn_volume<V>(random, Vec3(away * random_point(random)), own);
    };
    GapPair<V> pair;
    pair.a = volume();
    pair.b = volume();
    pair.b_to_a.rotation = drawn_rotation(random, pair.a, pair.b);
    const Mat3& rotation = pair.b_to_a.rotation;
    const Vec3 direction = drawn_direction(random, pair.a, pair.b, rotation);
    pair.gap = random.below(10) == 0 ? 0 : size * random_power(random, -12, 2);
    // Extents of B along it belong to the transposed matrix, also where it is not quite rigid.
    const Vec3 in_b = unit_or_zero(rotate(Mat3(rotation.transpose()), Vec3(-direction)));
    pair.point_a = drawn_far_point(random, pair.a, direction);
    pair.point_b = drawn_far_point(random, pair.b, in_b);
    pair.b_to_a.translation = pair.point_a + pair.gap * direction - rotate(rotation, pair.point_b);
    return pair;
}

}  // namespace scb
