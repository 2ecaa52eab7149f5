#pragma once

#include "core/volumes/convex_shape.h"

namespace scb {

/// How exactly a depth is looked for: until the bound is more than `enough`, or within a share of
/// the least reach that was met, or a number of directions were tried.
struct DepthSearch {
    double enough;
    double accuracy = 0.01;
    int most_directions = 6000;
};

/// A lower bound of how far B must be moved, in whatever direction, until it no longer overlaps A:
/// of the least reach of their difference, the sum of both supports less the distance of the
/// centers along the direction, over all directions. Negative or zero where they may be disjoint.
///
/// By branch and bound over the sphere. A point of the difference reaches along each direction of a
/// spherical triangle no less than along the one of its corners where it reaches least, so that any
/// point bounds a triangle; that of a corner is the better the smaller the triangle is, and those
/// with the lowest bounds are divided.
double least_depth(const ConvexShape& a, const ConvexShape& b, const DepthSearch& search);

}  // namespace scb
