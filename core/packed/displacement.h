#pragma once

#include "scb/ball.h"
#include "scb/pose.h"

namespace scb {

/// No point of the ball, in the body frame, has moved farther than this from where the body was at
/// the pose `from` to where it is at `to`, both in one frame; rounded up. Not much above the least
/// bound where the body's turn is small or the ball's center moves as its surface does. Infinite
/// where a pose is not a rigid one, see rigidity_defect; where it is one but for a defect, that is
/// allowed for.
double displacement_bound(const Pose& from, const Pose& to, const Ball& body);

}  // namespace scb
