#pragma once

#include "scb/vec.h"

namespace scb {

/// An oriented box: the points `center + axes * u` with |u[i]| <= half[i]. Closed.
struct Obb {
    /// The middle.
    Vec3 center = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< unit axes in the columns, a rotation
    Vec3 half = Vec3::Zero();      ///< half lengths along the axes
};

/// Surface area.
double surface_area(const Obb& box);
/// Volume.
double volume(const Obb& box);

/// Whether the point is inside or on the surface.
bool contains(const Obb& box, const Vec3& point);

/// Whether all is finite, the axes are a rotation to 1e-12 and no side is negative.
bool is_well_formed(const Obb& box);

/// How far the box reaches from its center in the unit direction `direction`.
double support(const Obb& box, const Vec3& direction);

/// The size that decides which of two volumes a traversal descends into: the longest half length,
/// as in RAPID (Gottschalk).
inline double descent_size(const Obb& box) { return box.half.maxCoeff(); }

/// Diameter: the diagonal, the counterpart of Section 3.1's d.
inline double diameter(const Obb& box) { return 2 * box.half.norm(); }
/// Thickness: the shortest side, the counterpart of Section 3.1's tau.
inline double thickness(const Obb& box) { return 2 * box.half.minCoeff(); }

}  // namespace scb
