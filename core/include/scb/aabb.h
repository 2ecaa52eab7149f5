#pragma once

#include <cmath>

#include "scb/vec.h"

namespace scb {

/// A box along the axes of its body's frame: the points with |x[i] - center[i]| <= half[i]. Closed.
/// In another frame it is an oriented box. Two tests are common, so the test is part of the type,
/// see overlap_aabb: `exact`, or, as in engines, A against the box along A's axes about the
/// turned B.
template <bool exact>
struct BasicAabb {
    /// The middle.
    Vec3 center = Vec3::Zero();
    Vec3 half = Vec3::Zero();  ///< half lengths
};
/// Tested against the box about the turned B, as in engines.
using Aabb = BasicAabb<false>;
/// Tested as the oriented box that it is.
using ExactAabb = BasicAabb<true>;

/// Surface area.
template <bool exact>
double surface_area(const BasicAabb<exact>& box) {
    const Vec3& h = box.half;
    return 8 * (h[0] * h[1] + h[1] * h[2] + h[2] * h[0]);
}

/// Volume.
template <bool exact>
double volume(const BasicAabb<exact>& box) {
    return 8 * box.half[0] * box.half[1] * box.half[2];
}

/// Whether the point is inside or on the surface.
template <bool exact>
bool contains(const BasicAabb<exact>& box, const Vec3& point) {
    return ((point - box.center).cwiseAbs().array() <= box.half.array()).all();
}

/// Whether all is finite and no side is negative.
template <bool exact>
bool is_well_formed(const BasicAabb<exact>& box) {
    return box.center.allFinite() && box.half.allFinite() && box.half.minCoeff() >= 0;
}

/// How far the box reaches from its center in the unit direction `direction`.
template <bool exact>
double support(const BasicAabb<exact>& box, const Vec3& direction) {
    return dot(box.half, Vec3(direction.cwiseAbs()));
}

/// The size that decides which of two volumes a traversal descends into: the longest half length.
template <bool exact>
double descent_size(const BasicAabb<exact>& box) {
    return box.half.maxCoeff();
}
/// Diameter: the diagonal.
template <bool exact>
double diameter(const BasicAabb<exact>& box) {
    return 2 * std::sqrt(squared_norm(box.half));
}
/// Thickness: the shortest side.
template <bool exact>
double thickness(const BasicAabb<exact>& box) {
    return 2 * box.half.minCoeff();
}

}  // namespace scb
