#pragma once

#include <cstdint>
#include <vector>

#include "scb/mesh.h"

namespace scb {

/// A point of a triangle of a mesh.
struct SurfaceSample {
    Vec3 point = Vec3::Zero();
    std::uint32_t triangle = 0;
};

/// `count` points of the surface, spread evenly over its area: a random one in each of `count`
/// equal parts of the area, in the order of the triangles. None if the mesh has no area. Always the
/// same points. `mesh` must satisfy check_mesh.
std::vector<SurfaceSample> surface_samples(const Mesh& mesh, std::size_t count);

/// The summed area of the triangles.
double surface_area(const Mesh& mesh);

}  // namespace scb
