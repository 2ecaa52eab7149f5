#include "core/volumes/placed_volume.h"

namespace scb {

Scb placed(const Scb& volume, const Pose& pose) {
    return {transform_point(pose, volume.c), volume.r, transform_direction(pose, volume.n),
            volume.e, volume.f};
}

Scb2 placed(const Scb2& volume, const Pose& pose) {
    Scb2 result = volume;
    result.c = transform_point(pose, volume.c);
    for (Slab& slab : result.slabs) slab.n = transform_direction(pose, slab.n);
    return result;
}

Ball placed(const Ball& volume, const Pose& pose) {
    return {transform_point(pose, volume.center), volume.radius};
}

Obb placed(const Obb& volume, const Pose& pose) {
    Obb result;
    result.center = transform_point(pose, volume.center);
    for (int i = 0; i < 3; ++i) result.axes.col(i) = transform_direction(pose, volume.axes.col(i));
    result.half = volume.half;
    return result;
}

}  // namespace scb
