#pragma once

#include <variant>

#include "core/volumes/convex_shape.h"
#include "core/volumes/placed_volume.h"
#include "core/volumes/shape.h"

namespace scb {

/// The shape_of a volume of any type, for pictures, files and reports that mix types.
using AnyVolume = std::variant<Scb, Ball, Obb, Scb2, ConvexShape>;

/// The center of the ball or the box (not of the slab).
Vec3 center(const AnyVolume& volume);

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
