#pragma once

#include <cstdint>
#include <vector>

#include "scb/mesh.h"
#include "scb/vec.h"

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

/// Area, centroid and scatter of a triangulated surface, from which the axes of an OBB follow. The
/// scatter is the integral of (x - centroid)(x - centroid)^T over the surface; kept relative to the
/// centroid, since raw moments cancel far from the origin.
struct SurfaceMoments {
    double area = 0;
    Vec3 centroid = Vec3::Zero();
    Mat3 scatter = Mat3::Zero();
};

/// The moments of one triangle.
SurfaceMoments triangle_moments(const Vec3& a, const Vec3& b, const Vec3& c);

/// The moments of two surfaces together (the parallel axis theorem).
SurfaceMoments merge(const SurfaceMoments& a, const SurfaceMoments& b);

}  // namespace scb
