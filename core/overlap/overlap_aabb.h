#pragma once

#include "core/overlap/overlap_obb.h"
#include "scb/aabb.h"

namespace scb {

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
