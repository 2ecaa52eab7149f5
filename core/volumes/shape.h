#pragma once

#include "core/volumes/convex_shape.h"
#include "scb/volume.h"

namespace scb {

/// A volume as one of the few shapes with pictures, files and exact verdicts: the volume itself, or
/// a shape of another type with the same set of points.
template <class V>
const V& shape_of(const V& volume) {
    return volume;
}
template <bool exact>
Obb shape_of(const BasicAabb<exact>& box) {
    return {box.center, Mat3::Identity(), box.half};
}
template <ConvexVolume V>
ConvexShape shape_of(const V& volume) {
    ConvexShape shape{center(volume), rounding(volume), Mat3::Identity(),
                      [volume](const Vec3& d) { return support_point(volume, d); }};
    if constexpr (requires { faces(volume); }) shape.faces = faces(volume);
    return shape;
}

}  // namespace scb
