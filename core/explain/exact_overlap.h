#pragma once

#include "core/explain/contact_certificate.h"

namespace scb {

/// Gaps and depths up to this share of the larger radius count as touching.
inline constexpr double contact_tolerance = 1e-9;

/// Whether two SCBs of one frame overlap: exact but for a margin of `tolerance` (1e-13 or more)
/// times the larger radius; within it they touch. Any SCB will do: a slab that leaves the center
/// out, no thickness, radius zero, parallel normals.
///
/// The margin of the result is a lower bound: no search is made for the greatest gap or the deepest
/// point, only for one above the tolerance. Two SCBs without thickness, nearly parallel, that
/// barely cross at their rims touch up to a depth of `tolerance` over the sine of their
/// angle; so does a single point of a sphere, a slab that only touches its ball, within the other.
/// Two such that are up to a few times `tolerance` apart may touch, too.
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
/// The condition asks for a point inside of A's ball within B's slab. Where A only touches that
/// slab there is none, however far from B the point is where it does. Then the directions of wider
/// slabs are tried, which hold such points: what separates A from a larger B separates it from B.
///
/// Other tests are made of candidate axes; these directions follow from closest points.
ContactCertificate exact_overlap(const Scb& a, const Scb& b, double tolerance = contact_tolerance);

/// The same of two balls: by the distance of their centers.
ContactCertificate exact_overlap(const Ball& a, const Ball& b,
                                 double tolerance = contact_tolerance);

/// The same of two balls with two slabs each. Closest points and directions as above: on up to
/// three of the eight planes, or on the sphere and up to two of them. The common point is the mean
/// of those found, and the depth that of boxes about it that fit into the two, so it is a lower
/// bound even of the depth at this point.
ContactCertificate exact_overlap(const Scb2& a, const Scb2& b,
                                 double tolerance = contact_tolerance);

/// The same of two boxes, times half the larger diagonal. The gap is the greatest along the 15
/// directions among which one separates two disjoint boxes (Gottschalk, Lin and Manocha, "OBBTree",
/// Section 5); a common point is looked for on the edges, of which one meets the other box where
/// two boxes overlap.
ContactCertificate exact_overlap(const Obb& a, const Obb& b, double tolerance = contact_tolerance);

/// The same of two convex volumes, times half the larger diagonal of their boxes: by the search of
/// Gilbert, Johnson and Keerthi for a direction that separates them, else by least_depth. Where its
/// directions run out they touch.
ContactCertificate exact_overlap(const ConvexShape& a, const ConvexShape& b,
                                 double tolerance = contact_tolerance);

/// The same verdict with a margin as great as a search finds, which climbs on proven_gap or
/// proven_depth: close to the distance, or the depth of a deep common point; less where two thin
/// volumes are nearly parallel and nearly touch. For people to look at.
ContactCertificate sharpened(const Scb& a, const Scb& b, const ContactCertificate& certificate);
ContactCertificate sharpened(const Scb2& a, const Scb2& b, const ContactCertificate& certificate);
ContactCertificate sharpened(const Ball& a, const Ball& b, const ContactCertificate& certificate);
ContactCertificate sharpened(const Obb& a, const Obb& b, const ContactCertificate& certificate);
ContactCertificate sharpened(const ConvexShape& a, const ConvexShape& b,
                             const ContactCertificate& certificate);

}  // namespace scb
