#pragma once

#include <limits>

#include "core/points.h"
#include "core/vec.h"

namespace scb {

// Passes over many points, four lanes at a time. Minimum and maximum do not depend on the order, so
// the result is that of the plain loop; each lane rounds as `contains` does, so what a pass bounds
// is contained exactly.

/// The largest |p - c|^2; 0 for no points.
double max_squared_distance(const PointsView& points, const Vec3& c);

/// An interval of signed distances; empty until extended.
struct Interval {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    double width() const { return upper - lower; }
};

/// Extends the interval by n.(p - c) of every point; gives up, with an interval at least `enough`
/// wide, as soon as it is. Returns how many points it looked at.
std::size_t extend(Interval& interval, const PointsView& points, const Vec3& c, const Vec3& n,
                   double enough = std::numeric_limits<double>::infinity());

/// The index of the first of the points that are farthest from c, and its squared distance.
struct Farthest {
    std::size_t index = 0;
    double squared_distance = -1;
};
Farthest farthest_point(const PointsView& points, const Vec3& c);

}  // namespace scb
