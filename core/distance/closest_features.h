#pragma once

#include <array>
#include <vector>

#include "scb/triangle_overlap.h"

namespace scb {

/// A corner, an edge or the face of each of two triangles, and where their lines or planes are
/// closest, from double-double arithmetic.
struct FeaturePair {
    std::array<double, 3> weights_a{}, weights_b{};  ///< of the corners, 0 or more
    /// From A to B, at a right angle to both features, of any length; zero if they meet.
    Vec3 direction = Vec3::Zero();
};

/// All pairs of features whose closest points are on both features; the closest first. There is at
/// least one. If the triangles do not intersect, the first has their distance, to the precision of
/// double-doubles.
std::vector<FeaturePair> closest_features_of(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
