#pragma once

#include <functional>

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
};

/// As of convex volumes.
inline double support(const ConvexShape& shape, const Vec3& d) {
    return dot(shape.support_point(d), d) + shape.rounding;
}
double diameter(const ConvexShape& shape);

/// The shape carried along by a rigid pose.
ConvexShape placed(const ConvexShape& shape, const Pose& pose);

/// The same points, as far as the directions of measured_directions tell.
bool identical(const ConvexShape& a, const ConvexShape& b);

}  // namespace scb
