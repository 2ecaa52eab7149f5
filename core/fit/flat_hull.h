#pragma once

#include <array>
#include <cstddef>

#include "core/fit/few_points.h"

namespace scb {

/// The convex hull of a few points of a plane.
class FlatHull {
  public:
    /// At most FewPoints::capacity of them.
    void add(double x, double y) { points_[count_++] = {x, y}; }

    /// A unit vector across which the points are least wide, the first of several: that of an edge
    /// of the hull. (1, 0) where all points coincide.
    std::array<double, 2> narrowest_direction();

  private:
    using Point = std::array<double, 2>;

    std::size_t keep_corners(std::array<Point, 2 * FewPoints::capacity>& hull);

    std::array<Point, FewPoints::capacity> points_;
    std::size_t count_ = 0;
};

}  // namespace scb
