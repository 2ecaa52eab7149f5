#pragma once

#include "core/volumes/any_volume.h"

namespace scb::render {

using scb::AnyVolume;

/// The `placed` of the volume's type, see core/volumes/placed_volume.h.
AnyVolume placed(const AnyVolume& volume, const Pose& pose);

/// Whether two volumes are the same numbers.
bool identical(const Scb& a, const Scb& b);
bool identical(const Scb2& a, const Scb2& b);
bool identical(const Ball& a, const Ball& b);
bool identical(const Obb& a, const Obb& b);
using scb::identical;
bool identical(const AnyVolume& a, const AnyVolume& b);

/// The largest `direction.x` over the points x of the volume, for a unit direction.
double reach(const AnyVolume& volume, const Vec3& direction);

}  // namespace scb::render
