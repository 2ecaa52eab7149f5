#pragma once

#include <cmath>

#include "scb/aabb.h"
#include "scb/obb.h"
#include "scb/placement.h"
#include "scb/stage.h"

namespace scb {

/// The first 3 or all 15 of the separating axes of Gottschalk, Lin and Manocha, "OBBTree: A
/// Hierarchical Structure for Rapid Interference Detection": the 6 face normals, then the 9 cross
/// products of edges. With all 15 it is exact, up to the margin. `a` and `b` are the half lengths;
/// `along_a(i, t, r)` sets t, the offset of the centers along the axis i of A, and row i of r, the
/// axes of B along it. The cross products are not normalized: if two edges are parallel, both sides
/// of the comparison vanish, and because of the margin the pair passes.
template <int axes, class AlongA>
Stage overlap_boxes(const Vec3& a, const Vec3& b, double margin, const AlongA& along_a) {
    static_assert(axes == 3 || axes == 15);
    using std::abs;
    // Everything in the frame of A's axes; s are absolute values of r.
    Vec3 t;
    Mat3 r, s;
    for (int i = 0; i < 3; ++i) {
        along_a(i, t[i], r);
        for (int j = 0; j < 3; ++j) s(i, j) = abs(r(i, j));
        if (abs(t[i]) > a[i] + b[0] * s(i, 0) + b[1] * s(i, 1) + b[2] * s(i, 2) + margin)
            return static_cast<Stage>(static_cast<int>(Stage::axis_a0) + i);
    }
    if constexpr (axes == 3) return Stage::overlapping;
    for (int j = 0; j < 3; ++j) {
        const double distance = abs(t[0] * r(0, j) + t[1] * r(1, j) + t[2] * r(2, j));
        if (distance > b[j] + a[0] * s(0, j) + a[1] * s(1, j) + a[2] * s(2, j) + margin)
            return static_cast<Stage>(static_cast<int>(Stage::axis_b0) + j);
    }
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double distance = abs(t[i2] * r(i1, j) - t[i1] * r(i2, j));
            if (distance >
                a[i1] * s(i2, j) + a[i2] * s(i1, j) + b[j1] * s(i, j2) + b[j2] * s(i, j1) + margin)
                return static_cast<Stage>(static_cast<int>(Stage::axis_a0_b0) + 3 * i + j);
        }
    }
    return Stage::overlapping;
}

/// Two oriented boxes, exactly.
inline Stage overlap_obb(const Obb& a, const Obb& b, const Placement& placed) {
    const Vec3 offset = transform_point(placed.b_to_a, b.center) - a.center;
    Mat3 turned;
    for (int j = 0; j < 3; ++j)
        turned.col(j) = transform_direction(placed.b_to_a, Vec3(b.axes.col(j)));
    return overlap_boxes<15>(a.half, b.half, placed.margin, [&](int i, double& t, Mat3& r) {
        const Vec3 axis = a.axes.col(i);
        t = dot(axis, offset);
        for (int j = 0; j < 3; ++j) r(i, j) = dot(axis, Vec3(turned.col(j)));
    });
}

/// Two boxes along the axes of their bodies: in A's frame, an upright box and a turned box. As in
/// engines, A is tested against the upright box about the turned one, with the first three of the
/// separating axes; or exactly, with all fifteen. For trees of such boxes see van den Bergen,
/// "Efficient Collision Detection of Complex Deformable Models using AABB Trees", 1997. The turned
/// axes are columns of the pose, so that only B's center is transformed.
template <bool exact>
Stage overlap_aabb(const BasicAabb<exact>& a, const BasicAabb<exact>& b, const Placement& placed) {
    const Vec3 offset = transform_point(placed.b_to_a, b.center) - a.center;
    return overlap_boxes < exact
               ? 15
               : 3 > (a.half, b.half, placed.margin, [&](int i, double& t, Mat3& r) {
                     t = offset[i];
                     for (int j = 0; j < 3; ++j) r(i, j) = placed.b_to_a.rotation(i, j);
                 });
}

}  // namespace scb
