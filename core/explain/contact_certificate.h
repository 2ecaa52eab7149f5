#pragma once

#include "core/base/enum_names.h"
#include "core/volumes/any_volume.h"

namespace scb {

/// Touching: neither farther apart nor deeper in each other than a tolerance.
enum class Contact { disjoint, overlapping, touching };

inline constexpr EnumNames<Contact, 3> contact_names = {"disjoint", "overlapping", "touching"};

/// The contact of two volumes of one frame, with its proof.
struct ContactCertificate {
    Contact contact = Contact::touching;
    /// Disjoint: the unit direction from A to B along which the two are `margin` apart.
    Vec3 direction = Vec3::Zero();
    /// Overlapping: a point of both, from the center of A. B must be moved by `margin` or more, in
    /// any direction, until it no longer overlaps A.
    Vec3 point = Vec3::Zero();
    /// A proven lower bound of the gap or depth. Zero if the two touch.
    double margin = 0;
};

/// The gap between A and B along a direction from A to B. Positive only if they are disjoint.
double proven_gap(const Scb& a, const Scb& b, const Vec3& direction);
double proven_gap(const Scb2& a, const Scb2& b, const Vec3& direction);
double proven_gap(const Ball& a, const Ball& b, const Vec3& direction);
double proven_gap(const Obb& a, const Obb& b, const Vec3& direction);
double proven_gap(const ConvexShape& a, const ConvexShape& b, const Vec3& direction);

/// A lower bound of how far B must be moved until it no longer overlaps A, from the surroundings of
/// a common point (`point` is from the center of A). Positive only if they overlap.
///
/// SCBs: A contains a cut ball about the point. Its radius is the point's distance to the sphere,
/// and half its thickness is the point's distance to the nearer plane. B likewise. The extent of
/// such a body, as a function of the angle to its normal, is concave and grows up to a right angle.
/// B has to move by the sum of both extents in a direction. So the least sum is along one of the
/// two normals. This also holds without thickness: two crossed discs overlap although no ball fits
/// into either.
///
/// A point that is outside of a slab by rounding, as is usual for a slab without thickness, proves
/// the same for a volume moved by this distance, which is subtracted. Boxes: the same with the
/// boxes about the point within them, whose sum is least along a face's normal, of A or of B, or
/// across an edge of each. Balls with two slabs: the same with boxes about the point that fit into
/// the two, or with balls, whichever proves more. Convex volumes: the point must be in both, and
/// the depth is from least_depth, which needs no surroundings.
double proven_depth(const Scb& a, const Scb& b, const Vec3& point);
double proven_depth(const Scb2& a, const Scb2& b, const Vec3& point);
double proven_depth(const Ball& a, const Ball& b, const Vec3& point);
double proven_depth(const Obb& a, const Obb& b, const Vec3& point);
double proven_depth(const ConvexShape& a, const ConvexShape& b, const Vec3& point);

// The next two functions are defined for the types of SCB_FOR_EACH_SHAPE.

/// Whether the certificate proves the verdict, by at least the stated margin, with proven_gap or
/// proven_depth and without exact_overlap. `sharpened` climbs on the same two functions, so its
/// margins need check_certificate as an independent check. False for `touching`, which claims
/// nothing, for lengths whose squares are not normal numbers, and for a direction that is not a
/// unit vector.
template <class V>
bool verify(const V& a, const V& b, const ContactCertificate& certificate);

/// Whether the farthest points of the two volumes support the certificate, by at least its margin.
/// For a gap, all of A must be before all of B in the direction. For a depth, in some thirty
/// directions, the point must be within both volumes, and B must reach into A by at least the
/// margin; this can refute a depth, but not prove it. False for `touching`, which claims nothing.
///
/// This check shares no code with proven_gap, proven_depth and verify, which make sharpened
/// certificates.
template <class V>
bool check_certificate(const V& a, const V& b, const ContactCertificate& certificate);

}  // namespace scb
