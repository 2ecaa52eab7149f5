#pragma once

#include "tests/core/scb_contact_proof.h"

namespace scb {

/// Whether two SCBs of one frame overlap: exact but for a margin of `tolerance` (1e-13 or more)
/// times the larger radius, and undecided rather than wrong within it. Any SCB will do: a slab that
/// leaves the center out, no thickness, radius zero, parallel normals.
///
/// The margin of the result is a lower bound: no search is made for the greatest gap or the deepest
/// point, only for one above the tolerance. Two SCBs without thickness, nearly parallel, that
/// barely cross at their rims stay undecided up to a depth of `tolerance` over the sine of their
/// angle; so does a single point of a sphere, a slab that only touches its ball, within the other.
///
/// Why a handful of formulas suffices. Let x be the point of A within B's slab that is closest to
/// the center of B: the two overlap where x exists and is in the ball of B. A projection onto two
/// slabs and a ball is on some of their boundaries, and for each choice of these it has a closed
/// form: on a plane, a line, the sphere, a circle, or one of two points of sphere and two planes.
/// Where the two are disjoint, the optimality condition of the projection (Boyd and Vandenberghe,
/// "Convex Optimization", Section 5.5.3) splits the direction from x to the center of B into
/// a part that supports A and a part that supports B: the direction of a plane between them. So one
/// of finitely many points or one of finitely many directions settles the question, and all are
/// tried, without deciding which boundaries are the right ones: what counts is what the point or
/// direction proves.
///
/// Other tests are made of candidate axes; these directions follow from closest points.
ContactProof exact_overlap(const Scb& a, const Scb& b, double tolerance = 1e-13);

}  // namespace scb
