#pragma once

#include "scb/vec.h"

namespace scb {

/// A closed ball: the points within `radius` of `center`, in the frame of the mesh that it bounds.
struct Ball {
    /// The middle.
    Vec3 center = Vec3::Zero();
    /// From the center to the surface.
    double radius = 0;
};

/// Surface area, 4 pi r^2.
double surface_area(const Ball& ball);

/// Volume, 4/3 pi r^3.
double volume(const Ball& ball);

/// Whether the point is inside or on the surface.
bool contains(const Ball& ball, const Vec3& point);

/// Whether center and radius are finite and the radius is not negative.
bool is_well_formed(const Ball& ball);

/// How far the ball reaches from its center in the unit direction `direction`.
double support(const Ball& ball, const Vec3& direction);

/// The smallest radius r for which r * r, as `contains` computes it, reaches the squared distance.
double radius_reaching(double squared_distance);

/// The size that decides which of two volumes a traversal descends into: the radius.
inline double descent_size(const Ball& ball) { return ball.radius; }

/// Diameter d = 2r, see Section 3.1 of the paper.
inline double diameter(const Ball& ball) { return 2 * ball.radius; }
/// Thickness, which is the diameter.
inline double thickness(const Ball& ball) { return 2 * ball.radius; }

}  // namespace scb
