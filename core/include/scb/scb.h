#pragma once

#include "scb/vec.h"

namespace scb {

/// A slab cut ball: the points x of a ball with `f <= n.(x - c) <= e` (Larsson and Akenine-Moller,
/// "Bounding Volume Hierarchies of Slab Cut Balls", Section 1.1). Closed. The symbols are the
/// paper's. `f <= e`, both within [-r, r]; a fitted SCB also has `f <= 0 <= e`. T is the scalar
/// type: double, or one that counts its operations.
template <class T>
struct BasicScb {
    Vector3<T> c = Vector3<T>::Zero();   ///< center of the ball
    T r = 0;                             ///< radius of the ball
    Vector3<T> n = Vector3<T>::UnitZ();  ///< unit normal of the two planes
    T e = 0;                             ///< signed distance from c to the upper plane, along n
    T f = 0;                             ///< signed distance from c to the lower plane, along n
};
/// In doubles: the volume of hierarchies.
using Scb = BasicScb<double>;

/// Surface area: the spherical zone and the two discs (equation 4).
double surface_area(const Scb& scb);

/// Volume (equation 5, with -f for |f|, so that it also holds if the center is outside the slab).
double volume(const Scb& scb);

/// Whether the point is inside or on the surface.
bool contains(const Scb& scb, const Vec3& point);

/// Whether all numbers are finite, n is a unit vector up to rounding, f <= e, and both are within
/// the radius.
bool is_well_formed(const Scb& scb);

/// How far the SCB reaches from c in the unit direction `direction`: max of direction.(x - c) over
/// the SCB. Exact; may be negative if the center is outside the slab.
double support(const Scb& scb, const Vec3& direction);

/// The size that decides which of two volumes a traversal descends into: the radius (Section 5).
inline double descent_size(const Scb& scb) { return scb.r; }

/// Diameter d = 2r (Section 3.1).
inline double diameter(const Scb& scb) { return 2 * scb.r; }
/// Thickness tau = e - f (Section 3.1).
inline double thickness(const Scb& scb) { return scb.e - scb.f; }

}  // namespace scb
