#pragma once

#include <cmath>

#include "scb/obb.h"
#include "scb/placement.h"
#include "scb/stage.h"

namespace scb {

/// Two oriented boxes by the 15 separating axes of Gottschalk, Lin and Manocha, "OBBTree: A
/// Hierarchical Structure for Rapid Interference Detection": the 6 face normals, then the 9 cross
/// products of edges. Exact, up to the placement's margin. The cross products are not normalized;
/// where two edges are parallel, both sides of the comparison vanish and the margin keeps the pair.
inline Stage overlap_obb(const Obb& a, const Obb& b, const Placement& placed) {
    using std::abs;
    const Vec3 offset = transform_point(placed.b_to_a, b.center) - a.center;
    Mat3 turned, r, s;
    for (int j = 0; j < 3; ++j)
        turned.col(j) = transform_direction(placed.b_to_a, Vec3(b.axes.col(j)));
    // Everything in the frame of A's axes: t the offset, r the axes of B, s their absolute values.
    Vec3 t;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = a.axes.col(i);
        t[i] = dot(axis, offset);
        for (int j = 0; j < 3; ++j) {
            r(i, j) = dot(axis, Vec3(turned.col(j)));
            s(i, j) = abs(r(i, j));
        }
        if (abs(t[i]) > a.half[i] + b.half[0] * s(i, 0) + b.half[1] * s(i, 1) +
                            b.half[2] * s(i, 2) + placed.margin)
            return static_cast<Stage>(static_cast<int>(Stage::axis_a0) + i);
    }
    for (int j = 0; j < 3; ++j) {
        const double distance = abs(t[0] * r(0, j) + t[1] * r(1, j) + t[2] * r(2, j));
        if (distance > b.half[j] + a.half[0] * s(0, j) + a.half[1] * s(1, j) + a.half[2] * s(2, j) +
                           placed.margin)
            return static_cast<Stage>(static_cast<int>(Stage::axis_b0) + j);
    }
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double distance = abs(t[i2] * r(i1, j) - t[i1] * r(i2, j));
            if (distance > a.half[i1] * s(i2, j) + a.half[i2] * s(i1, j) + b.half[j1] * s(i, j2) +
                               b.half[j2] * s(i, j1) + placed.margin)
                return static_cast<Stage>(static_cast<int>(Stage::axis_a0_b0) + 3 * i + j);
        }
    }
    return Stage::overlapping;
}

}  // namespace scb
