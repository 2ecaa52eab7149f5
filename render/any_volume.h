#pragma once

#include <variant>

#include "core/ball.h"
#include "core/obb.h"
#include "core/pose.h"
#include "core/scb.h"

namespace scb {

/// A volume of any type, for pictures that mix them.
using AnyVolume = std::variant<Scb, Ball, Obb>;

/// The volume carried along by a rigid pose: from the body's frame to the world's.
Scb placed(const Scb& volume, const Pose& pose);
Ball placed(const Ball& volume, const Pose& pose);
Obb placed(const Obb& volume, const Pose& pose);
AnyVolume placed(const AnyVolume& volume, const Pose& pose);

/// Whether two volumes are the same numbers.
bool identical(const Scb& a, const Scb& b);
bool identical(const Ball& a, const Ball& b);
bool identical(const Obb& a, const Obb& b);

/// The center of the ball or the box (not of the slab).
Vec3 center(const AnyVolume& volume);

/// The largest `direction.x` over the points x of the volume, for a unit direction.
double reach(const AnyVolume& volume, const Vec3& direction);

}  // namespace scb
