#pragma once

#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/pose.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// The volume carried along by a rigid pose: from the body's frame to that where the pose leads.
Scb placed(const Scb& volume, const Pose& pose);
Scb2 placed(const Scb2& volume, const Pose& pose);
Ball placed(const Ball& volume, const Pose& pose);
Obb placed(const Obb& volume, const Pose& pose);

}  // namespace scb
