#pragma once

#include <span>

#include "core/geometry/points.h"
#include "scb/ball.h"

namespace scb {

/// The smallest ball that contains the points. Exact to about 1e-14 relative, whatever the input:
/// duplicate, collinear, coplanar and cospherical points included. No points: a ball of radius 0 at
/// the origin.
///
/// Welzl ("Smallest enclosing disks", 1991) with Gartner's pivot ("Fast and robust smallest
/// enclosing balls", 1999): the farthest point joins the support, and the support is solved anew.
/// That subproblem has five points at most, so it is enumerated instead of recursed into. Linear in
/// the points per pivot; some ten pivots in practice.
Ball min_ball(std::span<const Vec3> points);

}  // namespace scb
