#pragma once

#include <span>
#include <vector>

#include "scb/convex.h"

namespace scb {

/// The corners of each face of the polytope within the planes, counterclockwise from outside;
/// planes without a face are left out. The polytope must be within the distance `size` of the
/// origin.
std::vector<std::vector<Vec3>> face_polygons(std::span<const FacePlane> planes, double size);

}  // namespace scb
