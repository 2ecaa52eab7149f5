#pragma once

#include <variant>

#include "core/volumes/convex_shape.h"
#include "core/volumes/placed_volume.h"

namespace scb::render {

/// A volume of any type, for pictures that mix them.
using AnyVolume = std::variant<Scb, Ball, Obb, Scb2, ConvexShape>;

/// As of each type, see core/volumes/placed_volume.h.
AnyVolume placed(const AnyVolume& volume, const Pose& pose);

/// Whether two volumes are the same numbers.
bool identical(const Scb& a, const Scb& b);
bool identical(const Scb2& a, const Scb2& b);
bool identical(const Ball& a, const Ball& b);
bool identical(const Obb& a, const Obb& b);
using scb::identical;

/// The center of the ball or the box (not of the slab).
Vec3 center(const AnyVolume& volume);

/// The largest `direction.x` over the points x of the volume, for a unit direction.
double reach(const AnyVolume& volume, const Vec3& direction);

}  // namespace scb::render
