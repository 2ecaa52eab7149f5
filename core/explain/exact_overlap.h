#pragma once

#include "core/explain/contact_certificate.h"
#include "scb/placement.h"

namespace scb {

/// Gaps and depths up to this share of the larger radius count as touching.
inline constexpr double contact_tolerance = 1e-9;

/// Whether two SCBs of one frame overlap: exact up to a margin of `tolerance` (1e-13 or more) times
/// the larger radius; within it they touch. Valid for any SCBs: a center outside the slab, no
/// thickness, radius zero, parallel normals.
///
/// The margin of the result is a lower bound: no search is made for the greatest gap or the deepest
/// point, only for one above the tolerance. Two nearly parallel SCBs without thickness that barely
/// cross at their rims touch up to a depth of `tolerance` over the sine of their angle. So does an
/// SCB that is a single point of a sphere, because its slab only touches its ball, within the
/// other. Such SCBs may also touch if they are up to a few times `tolerance` apart.
///
/// Why a few formulas suffice: Let x be the point of A within B's slab that is closest to the
/// center of B. The two overlap if x exists and is in the ball of B. A projection onto two slabs
/// and a ball is on some of their boundaries, and for each choice of these it has a closed form: on
/// a plane, a line, the sphere, a circle, or one of two points of sphere and two planes. If the two
/// are disjoint, the optimality condition of the projection (Boyd and Vandenberghe, "Convex
/// Optimization", Section 5.5.3) splits the direction from x to the center of B into a part that
/// supports A and a part that supports B: the direction of a plane between them. So one of finitely
/// many points or directions decides. All are tried, without a choice of the right boundaries,
/// since a point or direction proves the result by itself.
///
/// The condition needs a point inside of A's ball within B's slab. If A only touches that slab,
/// there is none, even if the touching point is far from B. Then the directions of wider slabs are
/// tried, which contain such points: a direction that separates A from a larger B separates it from
/// B.
///
/// Other tests try given axes; these directions follow from closest points.
ContactCertificate exact_overlap(const Scb& a, const Scb& b, double tolerance = contact_tolerance);

/// The same for two balls: by the distance of their centers.
ContactCertificate exact_overlap(const Ball& a, const Ball& b,
                                 double tolerance = contact_tolerance);

/// The same for two balls with two slabs each. Closest points and directions as above: on up to
/// three of the eight planes, or on the sphere and up to two of them. The common point is the mean
/// of the points found. The depth is from boxes about it that fit into the two, so it is a lower
/// bound even of the depth at this point.
ContactCertificate exact_overlap(const Scb2& a, const Scb2& b,
                                 double tolerance = contact_tolerance);

/// The same for two boxes; the tolerance is a share of half the larger diagonal. The gap is the
/// greatest along the 15 directions; one of these separates two disjoint boxes (Gottschalk, Lin and
/// Manocha, "OBBTree", Section 5). A common point is searched on the edges: if two boxes overlap,
/// an edge of one meets the other.
ContactCertificate exact_overlap(const Obb& a, const Obb& b, double tolerance = contact_tolerance);

/// The same for two convex volumes; the tolerance is a share of half the larger diagonal of their
/// boxes. By the search of Gilbert, Johnson and Keerthi for a separating direction, else by
/// least_depth. If this ends at its number of directions, they touch.
ContactCertificate exact_overlap(const ConvexShape& a, const ConvexShape& b,
                                 double tolerance = contact_tolerance);

/// The same verdict with a larger margin, by a search that climbs on proven_gap or proven_depth.
/// The margin is close to the distance, or to the depth of a deep common point; it is smaller if
/// two thin volumes are nearly parallel and nearly touch. For display. Defined for the types of
/// SCB_FOR_EACH_SHAPE.
template <class V>
ContactCertificate sharpened(const V& a, const V& b, ContactCertificate certificate);

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

// These functions are defined for the types of SCB_FOR_EACH_SHAPE.

/// The exact verdict on A, in its own frame, and B, in the frame that `placed` places: the
/// certificate of exact_overlap, in A's frame. If gap or depth is within the placement's margin,
/// the overlap tests cannot decide, and the verdict is that the two touch. Overlap tests are judged
/// by this verdict.
template <class V>
ContactCertificate exact_verdict(const V& a, const V& b, const Placement& placed);

/// Whether a plane across the line of the centers shows that the exact verdict is `disjoint`. False
/// for many that are disjoint.
template <class V>
bool apart_along_centers(const V& a, const V& b, const Placement& placed);

/// B in A's frame, for the exact verdict: normals are normalized again, since a pose that is rigid
/// to ten digits may change their lengths.
template <class V>
V seen_from_a(const V& b, const Placement& placed);

}  // namespace scb
