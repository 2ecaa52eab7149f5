#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/explain/contact_certificate.h"
#include "core/volumes/any_volume.h"
#include "core/volumes/convex_shape.h"
#include "scb/capsule.h"
#include "scb/mesh.h"
#include "scb/rss.h"

namespace scb {

/// A convex polytope: a k-DOP of any directions, or the hull of points.
struct Polytope {
    Vec3 center = Vec3::Zero();
    std::vector<Vec3> corners;  ///< relative to the center: all corners, perhaps with points inside
    std::vector<FacePlane> faces;  ///< relative to the center, with unit normals; empty: unknown
};

/// A box along the axes of its body with at least one side at infinity, as about a plane or a half
/// space.
struct OpenBox {
    Vec3 lower = Vec3::Constant(-HUGE_VAL);  ///< -HUGE_VAL where it is open
    Vec3 upper = Vec3::Constant(HUGE_VAL);
};

/// The box between these corners.
Obb box_between(const Vec3& lower, const Vec3& upper);
/// The box with its open sides cut at these corners; it keeps at least one point.
Obb cut_box(const OpenBox& box, const Vec3& lower, const Vec3& upper);

/// The volume of a node of any engine, in the body's frame. `monostate`: no volume that can be
/// judged. Axes and normals are as recorded: from 32-bit numbers, they are unit vectors to some
/// 1e-7.
using NodeVolume = std::variant<std::monostate, Obb, OpenBox, Ball, Capsule, Rss, Scb, Scb2,
                                std::shared_ptr<const Polytope>>;

inline bool has_volume(const NodeVolume& volume) { return volume.index() != 0; }

/// The polytope of all x with lower <= d.x <= upper for each direction d. `directions`: at least
/// one, three numbers each, not necessarily unit vectors. `bounds`: two numbers per direction.
/// Throws InputError, a clause that begins with "its", if the polytope is empty or unbounded.
Polytope slabs_polytope(std::span<const double> directions, std::span<const double> bounds);

/// How far a point is outside of the volume; not positive if it is inside. The distance or, for
/// polytopes and slab cut balls, a lower bound of it.
double excess(const NodeVolume& volume, const Vec3& point);

/// The volume by its support points. An open box ends at max_coordinate, and has faces only at its
/// finite sides.
ConvexShape convex_shape(const NodeVolume& volume);

/// The volume of a node of this project, by its support points. Exact, also for a ball cut by two
/// slabs: convex_shape of a NodeVolume has its whole ball.
ConvexShape exact_shape(const AnyVolume& volume);

/// The box along the axes about the shape.
Box box_about(const ConvexShape& shape);

/// The exact verdict on two volumes in A's frame. A is grown by `reach`, so volumes nearer than
/// `reach` overlap. They touch if the gap or depth is within
/// `tolerance`, a length. There is no verdict if one has no volume. There is none for a ball cut by
/// two slabs with a volume of another type, or with its center outside of a slab.
/// There is none for two open boxes that are turned against each other and do not meet near their
/// finite sides, or with a reach.
std::optional<ContactCertificate> proven_verdict(const NodeVolume& a, const NodeVolume& b,
                                                 const Pose& b_to_a, double tolerance,
                                                 double reach = 0);
/// The same for shapes that are exact; there is always a verdict.
ContactCertificate exact_verdict(const ConvexShape& a, const ConvexShape& b, const Pose& b_to_a,
                                 double tolerance, double reach);
/// The same; without a verdict the contact is touching, which claims nothing.
ContactCertificate exact_verdict(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                                 double tolerance, double reach = 0);

}  // namespace scb
