#pragma once

#include <span>

#include "scb/vec.h"

namespace scb {

/// What is known of the distance of two convex hulls, up to rounding.
enum class HullVerdict {
    apart,      ///< at least `enough`
    nearer,     ///< less
    undecided,  ///< too close to call
};

/// The verdict, and the direction along which the hulls are the farthest apart that was found.
struct HullSeparation {
    HullVerdict verdict = HullVerdict::undecided;
    Vec3 direction = Vec3::Zero();
};

/// Compares the distance of the hulls of two sets of points, not empty, with `enough`. It ends as
/// soon as either is known. `first`: a direction from A to B to begin with, not zero.
///
/// After Gilbert, Johnson and Keerthi, "A Fast Procedure for Computing the Distance Between Complex
/// Objects in Three-Dimensional Space" (1988). Each step has the farthest points in a direction:
/// their gap is below the distance. The hull of at most four such differences is a part of the
/// hulls' difference: its distance from the origin is above.
HullSeparation separate_hulls(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& first,
                              double enough);

}  // namespace scb
