#pragma once

#include "scb/ball.h"
#include "scb/placement.h"
#include "scb/stage.h"

namespace scb {

/// Two balls: exact, up to the placement's margin.
inline Stage overlap_ball(const Ball& a, const Ball& b, const Placement& placed) {
    const Vec3 c = transform_point(placed.b_to_a, b.center) - a.center;
    const double sum = a.radius + b.radius + placed.margin;
    return squared_norm(c) > sum * sum ? Stage::ball_ball : Stage::overlapping;
}

}  // namespace scb
