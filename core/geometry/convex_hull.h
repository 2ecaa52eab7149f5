#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scb/vec.h"

namespace scb {

struct ConvexHull {
    /// Indices of its vertices, ascending, and perhaps of some other points of its faces. All
    /// points if they lie in a plane.
    std::vector<std::uint32_t> vertices;
    double volume = 0;
};

/// The convex hull of points, by Quickhull (Barber, Dobkin and Huhdanpaa, "The Quickhull Algorithm
/// for Convex Hulls", 1996) with exact predicates, see orient3d: rounding never decides which
/// facets are visible, and the hull is the same on every machine. The volume is rounded, to some
/// 1e-15 of the cube of the points' extent. Points must be finite. O(n log n) for points in no
/// special order.
ConvexHull convex_hull(std::span<const Vec3> points);

}  // namespace scb
