#pragma once

#include <cmath>

#include "core/volumes/scb2_reach.h"
#include "scb/placement.h"
#include "scb/stage.h"

namespace scb {

/// The frames of two Scb2 in A's frame: first normal, second normal, long axis.
template <class T>
struct Scb2Frames {
    std::array<Vector3<T>, 3> a, b;
    /// Cosines of A's axes, in the rows, and B's: row i is A's axis i in B's frame, column j is B's
    /// axis j in A's frame.
    Matrix3<T> cosines;
    Vector3<T> c;     ///< B's center from A's
    Vector3<T> in_a;  ///< the same in A's frame
    Vector3<T> in_b;  ///< and in B's

    /// Nothing is measured yet.
    Scb2Frames(const BasicScb2<T>& volume_a, const BasicScb2<T>& volume_b, const Vector3<T>& to_b,
               const BasicPlacement<T>& placed)
        : c(to_b) {
        a = {volume_a.slabs[0].n, volume_a.slabs[1].n, long_axis(volume_a)};
        b[0] = transform_direction(placed.b_to_a, volume_b.slabs[0].n);
        b[1] = transform_direction(placed.b_to_a, volume_b.slabs[1].n);
        b[2] = cross(b[0], b[1]);
    }
    void measure_along_a(int axis) {
        const Vector3<T>& of_a = a[static_cast<std::size_t>(axis)];
        in_a[axis] = dot(of_a, c);
        for (int j = 0; j < 3; ++j) cosines(axis, j) = dot(of_a, b[static_cast<std::size_t>(j)]);
    }
    void measure_along_b(int axis) { in_b[axis] = dot(b[static_cast<std::size_t>(axis)], c); }
};

/// The product of the long axes, A's times B's, with the sign that leads from A to B; a unit vector
/// if the two are at right angles.
template <class T>
struct LongAxesProduct {
    Vector3<T> in_a;           ///< in A's frame, see Scb2Frames
    Vector3<T> in_b_reversed;  ///< its opposite in B's frame
    T length;
    T distance;  ///< of the centers along it, times `length`

    explicit LongAxesProduct(const Scb2Frames<T>& at) {
        using std::sqrt;
        in_a = Vector3<T>(-at.cosines(1, 2), at.cosines(0, 2), T(0));
        in_b_reversed = Vector3<T>(-at.cosines(2, 1), at.cosines(2, 0), T(0));
        length = sqrt(in_a[0] * in_a[0] + in_a[1] * in_a[1]);
        distance = in_a[0] * at.in_a[0] + in_a[1] * at.in_a[1];
        if (distance < 0) {
            distance = -distance;
            in_a = -in_a;
            in_b_reversed = -in_b_reversed;
        }
    }
};

/// Whether all of `other` is beyond one of the planes of the slab. `d` is the signed distance of
/// its center along the slab's normal, from the center of the slab's ball; `normal` is this normal
/// in the frame of `other`, see scb2_reach. Both centers are within their slabs, so only the plane
/// on the side of the center of `other` matters.
template <class T>
bool is_beyond_plane(const BasicSlab<T>& slab, const BasicScb2<T>& other, const T& d,
                     const Vector3<T>& normal, const BasicPlacement<T>& placed) {
    // If the center is within the slab, no plane separates the two.
    if (d < 0) return d < slab.f && -d - scb2_reach(other, normal, T(1)) > placed.margin - slab.f;
    return d > slab.e && d - scb2_reach(other, Vector3<T>(-normal), T(1)) > slab.e + placed.margin;
}

/// Two balls of two slabs each, by their exact extents: the balls; along the normals of A's slabs,
/// then of B's; along the line through the centers; along the product of the long axes, which
/// separates crossing needles. The last two directions are not unit vectors: if the axes are
/// parallel, both sides of the comparison vanish, and because of the margin the pair passes. Every
/// rejection has a separating direction. The long axes themselves and the other eight products
/// would reject few more pairs, see tests/volumes/README.md. T is the scalar type, see BasicScb.
template <class T>
Stage overlap_scb2(const BasicScb2<T>& a, const BasicScb2<T>& b, const BasicPlacement<T>& placed) {
    using std::sqrt;
    const Vector3<T> c = transform_point(placed.b_to_a, b.c) - a.c;
    const T sum = a.r + b.r + placed.margin;
    const T squared_distance = squared_norm(c);
    if (squared_distance > sum * sum) return Stage::ball_ball;

    Scb2Frames<T> at(a, b, c, placed);
    const auto is_beyond_a = [&](int i) {
        at.measure_along_a(i);
        return is_beyond_plane(a.slabs[static_cast<std::size_t>(i)], b, at.in_a[i],
                               Vector3<T>(at.cosines.row(i)), placed);
    };
    if (is_beyond_a(0)) return Stage::slab_a;
    if (is_beyond_a(1)) return Stage::second_slab_a;
    at.measure_along_a(2);
    const auto is_beyond_b = [&](int j) {
        at.measure_along_b(j);
        return is_beyond_plane(b.slabs[static_cast<std::size_t>(j)], a, T(-at.in_b[j]),
                               Vector3<T>(at.cosines.col(j)), placed);
    };
    if (is_beyond_b(0)) return Stage::slab_b;
    if (is_beyond_b(1)) return Stage::second_slab_b;
    at.measure_along_b(2);

    const T distance = sqrt(squared_distance);
    if (squared_distance - placed.margin * distance >
        scb2_reach(a, at.in_a, distance) + scb2_reach(b, Vector3<T>(-at.in_b), distance))
        return Stage::center_line;

    const LongAxesProduct<T> product(at);
    if (product.distance > scb2_reach(a, product.in_a, product.length) +
                               scb2_reach(b, product.in_b_reversed, product.length) + placed.margin)
        return Stage::long_axes;
    return Stage::overlapping;
}

}  // namespace scb
