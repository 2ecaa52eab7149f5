#pragma once

#include "scb/ball.h"
#include "scb/pose.h"

namespace scb {

/// An upper bound of the distance between any point of the ball, in the body frame, at the pose
/// `from` and the same point at the pose `to`, both in one frame. Not much above the least bound if
/// the body's turn is small, or if the ball's center moves as its surface does. Infinite if
/// rigidity_defect is infinite for a pose; smaller defects are included in the bound.
double displacement_bound(const Pose& from, const Pose& to, const Ball& body);

}  // namespace scb
