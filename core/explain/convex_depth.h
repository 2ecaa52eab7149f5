#pragma once

#include "core/volumes/convex_shape.h"

namespace scb {

/// When the search for a depth ends: if the bound is more than `enough`, or within the share
/// `accuracy` of the least extent found, or after a number of directions.
struct DepthSearch {
    double enough;
    double accuracy = 0.01;
    int most_directions = 6000;
};

/// A lower bound of how far B must be moved, in any direction, until it no longer overlaps A. It
/// bounds the least extent of their difference over all directions: the sum of both supports minus
/// the distance of the centers along the direction. Negative or zero if they may be disjoint.
///
/// By branch and bound over the sphere. For a spherical triangle, the extent of a point of the
/// difference in any direction is at least its least extent in the directions of the corners. So
/// any point bounds the triangle; the farthest point of a corner is better the smaller the triangle
/// is. Triangles with the lowest bounds are divided.
double least_depth(const ConvexShape& a, const ConvexShape& b, const DepthSearch& search);

}  // namespace scb
