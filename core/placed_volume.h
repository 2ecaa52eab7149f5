#pragma once

#include "core/ball.h"
#include "core/obb.h"
#include "core/pose.h"
#include "core/scb.h"

namespace scb {

/// The volume carried along by a rigid pose: from the body's frame to that where the pose leads.
Scb placed(const Scb& volume, const Pose& pose);
Ball placed(const Ball& volume, const Pose& pose);
Obb placed(const Obb& volume, const Pose& pose);

}  // namespace scb
