#pragma once

#include <span>
#include <vector>

#include "scb/convex.h"

namespace scb {

/// The corners of each face of the polytope within the planes, counterclockwise from outside; none
/// of a plane that the others leave nothing of. `size` is a length that the polytope does not
/// exceed, about the origin.
std::vector<std::vector<Vec3>> face_polygons(std::span<const FacePlane> planes, double size);

}  // namespace scb
