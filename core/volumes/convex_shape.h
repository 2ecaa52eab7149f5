#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scb/convex.h"
#include "scb/pose.h"
#include "scb/vec.h"

namespace scb {

/// A convex volume of any type and pose, given by its farthest points, for pictures, files and
/// exact verdicts. Not for traversals, which are compiled for each type.
struct ConvexShape {
    Vec3 center = Vec3::Zero();
    double rounding = 0;
    Mat3 axes = Mat3::Identity();                    ///< of its own frame, as columns
    std::function<Vec3(const Vec3&)> support_point;  ///< of the core, from the center
    std::vector<FacePlane> faces{};  ///< faces of a polytope, from the center; else empty
};

/// The `support` of a convex volume.
inline double support(const ConvexShape& shape, const Vec3& d) {
    return dot(shape.support_point(d), d) + shape.rounding;
}
/// Diameter: the diagonal of its box along the axes of its frame. Thickness: the shortest side of
/// this box.
double diameter(const ConvexShape& shape);
double thickness(const ConvexShape& shape);

/// The shape moved by a rigid pose.
ConvexShape placed(const ConvexShape& shape, const Pose& pose);

/// Planes about it, from the center: its faces, or, if it has none, the planes that touch it in
/// these directions of its own frame.
std::vector<FacePlane> planes_about(const ConvexShape& shape, std::span<const Vec3> directions);

/// Whether both reach equally far in all touching_directions.
bool identical(const ConvexShape& a, const ConvexShape& b);

/// The corners of each face of the polytope within the planes, counterclockwise from outside;
/// planes without a face are left out. The polytope must be within the distance `size` of the
/// origin.
std::vector<std::vector<Vec3>> face_polygons(std::span<const FacePlane> planes, double size);

/// Unit directions over the whole sphere, and triangles between them, counterclockwise from
/// outside: a grid of `steps` by `steps` on each face of a cube, so 6 steps^2 + 2 directions. With
/// an even number of steps, these include the axes, edges and corners of the cube, the directions
/// of kdop.h. A support function maps the grid to a mesh of its volume.
struct DirectionGrid {
    std::vector<Vec3> directions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
DirectionGrid direction_grid(int steps);

}  // namespace scb
