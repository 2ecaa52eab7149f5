#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <iterator>

#include "scb/placement.h"
#include "scb/stage.h"
#include "scb/volume.h"

namespace scb {

/// A lower bound of the distance of two volumes.
struct VolumeGap {
    double bound = 0;  ///< never above the distance, in spite of rounding
    /// The distance of the centers less the sizes of both: the order of volumes that overlap.
    double order = 0;
    Stage stage = Stage::overlapping;  ///< the directions of the largest bound
};

/// The middle of a volume, from which `support` measures.
template <class V>
Vec3 middle_of(const V& v) {
    if constexpr (requires { v.c; })
        return v.c;
    else if constexpr (requires { v.center; })
        return v.center;
    else
        return center(v);
}

/// The unit vector of this direction; zero if it has no length.
inline Vec3 unit_or_zero(const Vec3& v) {
    const double length = std::sqrt(squared_norm(v));
    return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// Three unit directions at right angles: `first`, the rest of `second` beside it, and their
/// product. Zero vectors if there are none.
inline std::array<Vec3, 3> frame_about(const Vec3& first, const Vec3& second) {
    const Vec3 n = unit_or_zero(first), rest = unit_or_zero(second - dot(n, second) * n);
    Vec3 beside = unit_or_zero(rest - dot(n, rest) * n);
    // Of parallel directions, only rounding is left.
    if (std::abs(dot(n, beside)) > 0x1p-40) beside = Vec3::Zero();
    return {n, beside, cross(n, beside)};
}

/// Directions at right angles along which the volume is thin, in its own frame. `to_other`: from
/// its middle to the middle of the other volume; a volume that is round about an axis has its
/// second direction there.
template <class V>
std::array<Vec3, 3> thin_frame(const V& v, const Vec3& to_other) {
    if constexpr (std::same_as<V, Scb>)
        return frame_about(v.n, to_other);
    else if constexpr (std::same_as<V, Scb2>)
        return frame_about(v.slabs[0].n, v.slabs[1].n);
    else if constexpr (std::same_as<V, Obb>)
        return frame_about(v.axes.col(0), v.axes.col(1));
    else if constexpr (requires { v.half_axis; })
        return frame_about(v.half_axis, to_other);
    else if constexpr (requires { v.half_sides; })
        return frame_about(cross(v.half_sides[0], v.half_sides[1]), v.half_sides[0]);
    else
        return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
}

/// Whether a volume may be longer along one axis than across.
template <class V>
inline constexpr bool has_long_direction = std::same_as<V, Scb2> || std::same_as<V, Obb> ||
                                           requires(const V& v) {
    v.half_axis;
}
|| requires(const V& v) { v.half_sides; };

/// The axis along which a long volume extends.
template <class V>
requires has_long_direction<V> Vec3 long_direction(const V& v) {
    if constexpr (std::same_as<V, Scb2>) {
        return long_axis(v);
    } else if constexpr (std::same_as<V, Obb>) {
        int longest = 0;
        for (int i = 1; i < 3; ++i)
            if (v.half[i] > v.half[longest]) longest = i;
        return v.axes.col(longest);
    } else if constexpr (requires { v.half_axis; }) {
        return v.half_axis;
    } else {
        return v.half_sides[squared_norm(v.half_sides[0]) < squared_norm(v.half_sides[1]) ? 1 : 0];
    }
}

/// Bounds of the distance of two volumes along directions.
template <class V>
class GapSearch {
  public:
    GapSearch(const V& a, const V& b, const Placement& placed)
        : a_(a),
          b_(b),
          placed_(placed),
          to_b_(transform_point(placed.b_to_a, middle_of(b)) - middle_of(a)) {}

    const Vec3& to_b() const { return to_b_; }

    /// The gap of the extents along a unit direction; not positive if they overlap.
    double along(const Vec3& direction) const {
        const double distance = dot(direction, to_b_);
        // Only the side of B matters, unless a volume leaves out its center.
        double gap = of_side(distance < 0 ? Vec3(-direction) : direction, std::abs(distance));
        if constexpr (std::same_as<V, Scb>)
            gap = std::max(
                gap, of_side(distance < 0 ? direction : Vec3(-direction), -std::abs(distance)));
        return gap;
    }

    /// The root of the squared gaps along directions at right angles, which a squared distance
    /// exceeds.
    double along_frame(const std::array<Vec3, 3>& frame) const {
        double squared = 0;
        for (const Vec3& direction : frame) {
            const double gap = std::max(0.0, along(direction));
            squared += gap * gap;
        }
        return std::sqrt(squared) * (1 - 4 * (placed_.squared_sine_bound - 1));
    }

    Vec3 to_frame_of_b(const Vec3& direction) const {
        const Mat3& r = placed_.b_to_a.rotation;
        return {dot(Vec3(r.col(0)), direction), dot(Vec3(r.col(1)), direction),
                dot(Vec3(r.col(2)), direction)};
    }

  private:
    double of_side(const Vec3& direction, double distance) const {
        // The pose may be rigid to 1e-9 only, so the length is not quite 1.
        const Vec3 in_b = to_frame_of_b(Vec3(-direction));
        const double length = std::sqrt(squared_norm(in_b));
        if (!(length > 0)) return 0;
        const double of_a = support(a_, direction),
                     of_b = length * support(b_, Vec3(in_b / length));
        constexpr double rounding = 0x1p-48;
        return distance - of_a - of_b - placed_.margin -
               rounding * (std::abs(distance) + std::abs(of_a) + std::abs(of_b));
    }

    const V &a_, &b_;
    const Placement& placed_;
    Vec3 to_b_;
};

/// The points and directions that volume_gap moves from one frame to the other: B's center, and the
/// line of the centers; A's three axes; two axes of B, and three back; the long axis and the
/// product; each face of a k-DOP, and B's faces back.
template <Volume V>
constexpr std::uint64_t transforms_per_gap() {
    if constexpr (std::same_as<V, Ball>) return 2;
    std::uint64_t count = has_long_direction<V> ? 12 : 10;
    if constexpr (requires { V::which; }) count += 3 * std::size(V::which);
    return count;
}

/// The largest of these bounds: along the line of the centers; the gaps along A's axes as a root of
/// squares, and along B's; along the product of the long axes; and along the faces of k-DOPs. Of
/// equal bounds, the first.
template <Volume V>
VolumeGap volume_gap(const V& a, const V& b, const Placement& placed) {
    const GapSearch<V> search(a, b, placed);
    const double distance = std::sqrt(squared_norm(search.to_b()));
    VolumeGap gap;
    gap.order = distance - 0.5 * (diameter(a) + diameter(b));
    const auto take = [&gap](double bound, Stage stage) {
        if (bound <= gap.bound) return;
        gap.bound = bound;
        gap.stage = stage;
    };
    if (distance > 0) take(search.along(search.to_b() / distance), Stage::center_line);
    if constexpr (!std::same_as<V, Ball>) {
        const auto to_a = [&placed](const Vec3& direction) {
            return transform_direction(placed.b_to_a, direction);
        };
        take(search.along_frame(thin_frame(a, search.to_b())), Stage::slab_a);
        const std::array<Vec3, 3> own = thin_frame(b, search.to_frame_of_b(Vec3(-search.to_b())));
        const std::array<Vec3, 3> of_b = frame_about(to_a(own[0]), to_a(own[1]));
        take(search.along_frame(of_b), Stage::slab_b);
        if constexpr (has_long_direction<V>) {
            const Vec3 product = unit_or_zero(cross(long_direction(a), to_a(long_direction(b))));
            take(search.along(product), Stage::long_axes);
        }
        if constexpr (requires { V::which; })
            for (const int which : V::which) {
                const auto& d = dop_directions[static_cast<std::size_t>(which)];
                const Vec3 direction(d[0], d[1], d[2]);
                take(search.along(unit_or_zero(direction)), Stage::slab_a);
                take(search.along(unit_or_zero(to_a(direction))), Stage::slab_b);
            }
    }
    return gap;
}

}  // namespace scb
