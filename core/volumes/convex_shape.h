#pragma once

#include <functional>
#include <vector>

#include "scb/convex.h"
#include "scb/pose.h"

namespace scb {

/// A convex volume of any type and pose, by its farthest points: what pictures, files and exact
/// verdicts know of it. Not for traversals, which are compiled for each type.
struct ConvexShape {
    Vec3 center = Vec3::Zero();
    double rounding = 0;
    Mat3 axes = Mat3::Identity();  ///< those of its own frame, as columns: where its faces may be
    std::function<Vec3(const Vec3&)> support_point;  ///< of the core, from the center
    std::vector<FacePlane> faces{};  ///< of a polytope that knows them, from the center
};

/// As of convex volumes.
inline double support(const ConvexShape& shape, const Vec3& d) {
    return dot(shape.support_point(d), d) + shape.rounding;
}
/// Of the box of the frame's axes about it: the diagonal, and the shortest side.
double diameter(const ConvexShape& shape);
double thickness(const ConvexShape& shape);

/// The shape carried along by a rigid pose.
ConvexShape placed(const ConvexShape& shape, const Pose& pose);

/// Planes about it, from the center: the faces of a polytope that knows them, else those that touch
/// it in these directions of its own frame.
std::vector<FacePlane> planes_about(const ConvexShape& shape, std::span<const Vec3> directions);

/// The same points, as far as the directions of touching_directions tell.
bool identical(const ConvexShape& a, const ConvexShape& b);

}  // namespace scb
