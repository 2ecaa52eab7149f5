#pragma once

#include <cstddef>

#include "scb/triangle_overlap.h"
#include "tests/core/distance/precise_point.h"

namespace scb {

/// Bounds of the distance of two triangles.
struct ProvenTriangleDistance {
    precise::Real lower, upper;
};

/// The bounds, proven by two points and by a direction in double-double arithmetic: up to 2^-90 of
/// the coordinates. They are valid however the points were found. Both are 0 if the exact test
/// finds that the triangles intersect.
ProvenTriangleDistance proven_triangle_distance(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
