#pragma once

#include <array>
#include <span>

namespace scb {

using FlatPoint = std::array<double, 2>;

/// A unit vector across which points of a plane are least wide: the direction of an edge of their
/// convex hull, the first of several. (1, 0) if all points coincide, or there are none. At most
/// FewPoints::capacity points; they are sorted in place.
FlatPoint narrowest_direction(std::span<FlatPoint> points);

}  // namespace scb
