#pragma once

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

}  // namespace scb
