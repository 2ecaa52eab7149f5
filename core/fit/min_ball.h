#pragma once

#include <span>

#include "core/geometry/points.h"
#include "scb/ball.h"

namespace scb {

/// The smallest ball that contains the points. Exact to about 1e-14 relative for any input, also
/// duplicate, collinear, coplanar and cospherical points. Without points, a ball of radius 0 at the
/// origin.
///
/// Welzl ("Smallest enclosing disks", 1991) with Gartner's pivot ("Fast and robust smallest
/// enclosing balls", 1999): the farthest point joins the support, whose smallest ball is then
/// solved. The support has five points at most, so its subsets are enumerated without recursion.
/// Linear in the points per pivot; some ten pivots in practice.
Ball min_ball(std::span<const Vec3> points);

}  // namespace scb
