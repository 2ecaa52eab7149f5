#pragma once

#include <array>
#include <vector>

#include "scb/triangle_overlap.h"

namespace scb {

/// Where a corner, an edge or the face of one triangle is closest to one of another, from
/// double-double arithmetic.
struct PreciseFeatures {
    std::array<double, 3> weights_a{}, weights_b{};  ///< of the corners, 0 or more
    /// From A to B, at a right angle to both features; of any length.
    Vec3 direction = Vec3::Zero();
};

/// All pairs of features that are closest inside of both; the closest pair first. There is at least
/// one. If the triangles do not intersect, the first has their distance.
std::vector<PreciseFeatures> precise_features(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
