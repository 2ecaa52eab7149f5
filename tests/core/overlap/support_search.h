#pragma once

#include <initializer_list>

#include "scb/scb.h"

namespace scb {

/// Bounds on the distance of two slab cut balls of one frame, from a search on farthest points
/// alone. The search is independent of exact_overlap and of the code that makes its certificates.
struct SupportBounds {
    /// The distance of the two is at least `lower`, which is negative where no plane between them
    /// has been found, and at most `upper`.
    double lower = 0, upper = 0;
    /// B has to be moved by this or more to be rid of A; 0 where that has not been shown.
    double depth = 0;
};

/// Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex
/// objects in three-dimensional space" (1988), on the set of differences of points of B and points
/// of A: the point of it that is closest to the origin is approached by the closest points of
/// simplices with up to four corners on its surface. Both bounds hold up to some 1e-14 of the
/// sizes, also if rounding misleads the search: `upper` is the length of a mean of such corners,
/// `lower` what the farthest points of A and B along a direction leave between them. The search
/// ends once `lower` is more than `enough`; else where it makes no more progress.
///
/// Where no plane is between the two, the same search asks whether the set also holds the corners
/// of a regular tetrahedron about the origin. If so, it holds the ball within that, whose radius is
/// a depth. The values in `depths` are tried in descending order; `depth` is the first that is
/// shown.
SupportBounds search_supports(const Scb& a, const Scb& b, double enough,
                              std::initializer_list<double> depths);

}  // namespace scb
