#pragma once

#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb {

/// The box of the vertices that triangles use, after the pose.
Box bounding_box(const Mesh& mesh, const Pose& pose);

/// The gap between two boxes along each axis: from x to y, positive or negative, 0 if they overlap
/// along it.
Vec3 gap_between(const Box& x, const Box& y);

}  // namespace scb
