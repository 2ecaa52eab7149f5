#pragma once

#include <algorithm>
#include <array>

#include "scb/vec.h"

namespace scb {

/// One slab of an Scb2: `f <= n.(x - c) <= e`.
template <class T>
struct BasicSlab {
    Vector3<T> n = Vector3<T>::UnitZ();  ///< unit normal of the two planes
    T e = 0;                             ///< signed distance from c to the upper plane, along n
    T f = 0;                             ///< signed distance from c to the lower plane, along n
};
/// In doubles.
using Slab = BasicSlab<double>;

/// A ball cut by two slabs at right angles, the "0 to 2 slabs" of Larsson and Akenine-Moller,
/// "Bounding Volume Hierarchies of Slab Cut Balls", Section 6. Closed. Where a slab does not cut,
/// `e = r` and `f = -r`. `f <= 0 <= e`, both within [-r, r]. T is the scalar type, see BasicScb.
template <class T>
struct BasicScb2 {
    Vector3<T> c = Vector3<T>::Zero();  ///< center of the ball
    T r = 0;                            ///< radius of the ball
    /// The slabs, both measured from c.
    std::array<BasicSlab<T>, 2> slabs = {BasicSlab<T>{}, {Vector3<T>::UnitX(), 0, 0}};
};
/// In doubles: the volume of hierarchies.
using Scb2 = BasicScb2<double>;

/// The unit direction along both slabs, the axis of a needle.
template <class T>
Vector3<T> long_axis(const BasicScb2<T>& scb) {
    return cross(scb.slabs[0].n, scb.slabs[1].n);
}

/// Surface area, in closed form.
double surface_area(const Scb2& scb);

/// Volume, by the divergence theorem: a third of each face times its distance from the center.
double volume(const Scb2& scb);

/// Whether the point is inside or on the surface.
bool contains(const Scb2& scb, const Vec3& point);

/// Whether all numbers are finite, the normals are unit vectors at right angles up to rounding, and
/// `-r <= f <= 0 <= e <= r`.
bool is_well_formed(const Scb2& scb);

/// How far it reaches from c in the unit direction `direction`: max of direction.(x - c). Exact.
double support(const Scb2& scb, const Vec3& direction);

/// The size that decides which of two volumes a traversal descends into: the radius (Section 5).
inline double descent_size(const Scb2& scb) { return scb.r; }

/// Diameter d = 2r (Section 3.1).
inline double diameter(const Scb2& scb) { return 2 * scb.r; }
/// Thickness tau of the thinner slab (Section 3.1).
inline double thickness(const Scb2& scb) {
    const auto of = [](const Slab& s) { return s.e - s.f; };
    return std::min(of(scb.slabs[0]), of(scb.slabs[1]));
}

}  // namespace scb
