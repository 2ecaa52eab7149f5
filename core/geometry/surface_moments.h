#pragma once

#include "scb/vec.h"

namespace scb {

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
