#pragma once

#include <array>
#include <span>

namespace scb {

using FlatPoint = std::array<double, 2>;

/// A unit vector across which points of a plane are least wide, the first of several: that of an
/// edge of their convex hull. (1, 0) where all points coincide, or there are none. There are at
/// most FewPoints::capacity of them; they are put in order.
FlatPoint narrowest_direction(std::span<FlatPoint> points);

}  // namespace scb
