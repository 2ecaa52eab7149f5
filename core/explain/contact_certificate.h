#pragma once

#include "core/base/enum_names.h"
#include "core/volumes/convex_shape.h"
#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// Touching: neither farther apart nor deeper in each other than a tolerance.
enum class Contact { disjoint, overlapping, touching };

inline constexpr EnumNames<Contact, 3> contact_names = {"disjoint", "overlapping", "touching"};

/// What was found about two volumes of one frame, with what proves it.
struct ContactCertificate {
    Contact contact = Contact::touching;
    /// Disjoint: the unit direction from A to B along which the two are `margin` apart.
    Vec3 direction = Vec3::Zero();
    /// Overlapping: a point of both, from the center of A. B must be moved by `margin` or more, in
    /// whatever direction, until it no longer overlaps A.
    Vec3 point = Vec3::Zero();
    /// A proven lower bound of the gap or depth. Zero where the two touch.
    double margin = 0;
};

/// How far A and B are apart along a direction from A to B. Positive only for disjoint ones.
double proven_gap(const Scb& a, const Scb& b, const Vec3& direction);
double proven_gap(const Scb2& a, const Scb2& b, const Vec3& direction);
double proven_gap(const Ball& a, const Ball& b, const Vec3& direction);
double proven_gap(const Obb& a, const Obb& b, const Vec3& direction);
double proven_gap(const ConvexShape& a, const ConvexShape& b, const Vec3& direction);

/// How far B must be moved at least, until it no longer overlaps A, as far as the surroundings of a
/// common point show (`point` is from the center of A). Positive only for overlapping ones.
///
/// Of SCBs: A holds the ball about the point with the point's distance to the sphere as its radius,
/// cut by a slab about the point with its distance to the nearer plane as half the thickness; B
/// likewise. The reach of such a body, as a function of the angle to its normal, is concave and
/// grows up to a right angle. So the sum of both reaches in a direction, which is how far B has to
/// go in that direction, is least along one of the two normals. That counts an SCB without
/// thickness as what it is: two crossed discs overlap although no ball fits into either.
///
/// A point that is outside of a slab by rounding, as for a slab without thickness it will be,
/// proves the same of a copy moved by so much, which is deducted. Of boxes the same with the boxes
/// about the point within them, whose sum is least along a face's normal: of A, of B, or across an
/// edge of each. Of balls with two slabs the same with boxes about the point that fit into the two,
/// or with balls, whichever shows more. Of convex volumes the point must be in both, and the depth
/// is that of least_depth, which asks for no surroundings.
double proven_depth(const Scb& a, const Scb& b, const Vec3& point);
double proven_depth(const Scb2& a, const Scb2& b, const Vec3& point);
double proven_depth(const Ball& a, const Ball& b, const Vec3& point);
double proven_depth(const Obb& a, const Obb& b, const Vec3& point);
double proven_depth(const ConvexShape& a, const ConvexShape& b, const Vec3& point);

/// Whether the certificate shows the verdict, by at least the stated margin: proven_gap or
/// proven_depth, with nothing of exact_overlap. Of a margin that `sharpened` found by climbing on
/// these two it says no more than that; see check_certificate. `touching` claims nothing and is
/// never verified, nor are lengths whose squares are no normal numbers, or a direction that is no
/// unit vector.
bool verify(const Scb& a, const Scb& b, const ContactCertificate& certificate);
bool verify(const Scb2& a, const Scb2& b, const ContactCertificate& certificate);
bool verify(const Ball& a, const Ball& b, const ContactCertificate& certificate);
bool verify(const Obb& a, const Obb& b, const ContactCertificate& certificate);
bool verify(const ConvexShape& a, const ConvexShape& b, const ContactCertificate& certificate);

}  // namespace scb
