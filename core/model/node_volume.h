#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/explain/contact_certificate.h"
#include "core/volumes/convex_shape.h"
#include "scb/capsule.h"
#include "scb/mesh.h"
#include "scb/rss.h"

namespace scb {

/// A convex polytope: that of a k-DOP of whatever directions, or the hull of points.
struct Polytope {
    Vec3 center = Vec3::Zero();
    std::vector<Vec3> corners;     ///< from the center; all of them, perhaps with others inside
    std::vector<FacePlane> faces;  ///< from the center, with unit normals; empty: not known
};

/// A box along the axes of its body, of which at least one side is at infinity: that of a plane or
/// a half space.
struct OpenBox {
    Vec3 lower = Vec3::Constant(-HUGE_VAL);  ///< -HUGE_VAL where it is open
    Vec3 upper = Vec3::Constant(HUGE_VAL);
};

/// The box between these corners.
Obb box_between(const Vec3& lower, const Vec3& upper);
/// The part of the box between these corners, which has at least one point.
Obb cut_box(const OpenBox& box, const Vec3& lower, const Vec3& upper);

/// The volume of a node, of whatever engine, in the body's frame. `monostate`: none that one could
/// judge. Axes and normals are as the engine has them: of one that computes in 32 bits, unit
/// vectors to some 1e-7.
using NodeVolume = std::variant<std::monostate, Obb, OpenBox, Ball, Capsule, Rss, Scb, Scb2,
                                std::shared_ptr<const Polytope>>;

inline bool has_volume(const NodeVolume& volume) { return volume.index() != 0; }

/// What is between two planes in each of the directions: lower <= d.x <= upper. Directions are
/// three numbers each and need not be unit vectors, at least one; `bounds` are two per direction.
/// Throws InputError, a clause that begins with "its", where they leave nothing or do not bound it.
Polytope slabs_polytope(std::span<const double> directions, std::span<const double> bounds);

/// How far a point is outside of the volume: the distance or, of polytopes and slabs, at least that
/// of the farthest plane. Not positive: it is inside.
double excess(const NodeVolume& volume, const Vec3& point);

/// The same volume by its farthest points; an open box ends at max_coordinate, and has the faces
/// of its finite sides.
ConvexShape convex_shape(const NodeVolume& volume);

/// The box along the axes about it.
Box box_about(const ConvexShape& shape);

/// The exact verdict on two volumes, in A's frame. They touch where gap or depth is within
/// `tolerance`, a length. There is no verdict where one has no volume, on a ball cut by two slabs
/// with a volume of another type, or with a center outside of one of its slabs, and on two open
/// boxes that are turned against each other and do not meet near their finite sides.
std::optional<ContactCertificate> proven_verdict(const NodeVolume& a, const NodeVolume& b,
                                                 const Pose& b_to_a, double tolerance);
/// The same; touching, which claims nothing, where there is no verdict.
ContactCertificate exact_verdict(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                                 double tolerance);

}  // namespace scb
