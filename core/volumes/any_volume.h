#pragma once

#include <variant>

#include "core/volumes/convex_shape.h"
#include "core/volumes/shape.h"
#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/pose.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// The volume moved by a rigid pose, from the body's frame to the frame that the pose maps to.
Scb placed(const Scb& volume, const Pose& pose);
Scb2 placed(const Scb2& volume, const Pose& pose);
Ball placed(const Ball& volume, const Pose& pose);
Obb placed(const Obb& volume, const Pose& pose);

/// The shape_of a volume of any type, for pictures, files and reports that mix types.
using AnyVolume = std::variant<Scb, Ball, Obb, Scb2, ConvexShape>;

/// Calls the macro X with the type of each shape of AnyVolume, to instantiate templates.
#define SCB_FOR_EACH_SHAPE(X) X(Scb) X(Ball) X(Obb) X(Scb2) X(ConvexShape)

/// The center of the ball or the box (not of the slab) of a shape of AnyVolume.
template <class V>
const Vec3& shape_center(const V& shape) {
    if constexpr (requires { shape.center; })
        return shape.center;
    else
        return shape.c;
}

AnyVolume placed(const AnyVolume& volume, const Pose& pose);

/// The shape_center of the shape.
Vec3 center(const AnyVolume& volume);

/// Whether two volumes are the same numbers.
bool identical(const Scb& a, const Scb& b);
bool identical(const Scb2& a, const Scb2& b);
bool identical(const Ball& a, const Ball& b);
bool identical(const Obb& a, const Obb& b);
bool identical(const AnyVolume& a, const AnyVolume& b);

/// The largest `direction.x` over the points x of the volume, for a unit direction.
double reach(const AnyVolume& volume, const Vec3& direction);

/// The extents of a volume: the diameter and the thickness of Section 3.1 of the paper, d = 2r and
/// tau = e - f; for an OBB the diagonal and the shortest side.
struct VolumeLengths {
    double diameter = 0, thickness = 0;
};

template <class V>
VolumeLengths lengths_of(const V& volume) {
    return {diameter(volume), thickness(volume)};
}

/// The same with area and volume.
struct VolumeSize : VolumeLengths {
    double area = 0, volume = 0;
};

template <class V>
VolumeSize size_of(const V& v) {
    return {lengths_of(v), surface_area(v), volume(v)};
}
/// Area and volume are measured on the polytope of planes_about.
VolumeSize size_of(const ConvexShape& shape);

}  // namespace scb
