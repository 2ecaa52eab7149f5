#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "scb/scb2.h"

namespace scb {

/// How far an Scb2 reaches from its center along a direction, times the direction's length:
/// max of d.(x - c). `along` has the components of d along the first normal, the second one and the
/// long axis; `length` is its length.
///
/// Let k0 and k1 be the planes on the sides to which d leads. If no plane cuts off the farthest
/// point of the ball, it is the result. Else it is the farthest point of the rim in which a plane
/// cuts the ball, if the other plane does not cut this point off. Else it is one of the two points
/// in which the planes meet the sphere. Only the difference under the last root can cancel, and its
/// factor is then small: the error is a few units in the last place of r times `length`.
template <class T>
T scb2_reach(const BasicScb2<T>& s, const Vector3<T>& along, const T& length) {
    using std::abs;
    using std::max;
    using std::sqrt;
    const T k0 = along[0] >= 0 ? s.slabs[0].e : -s.slabs[0].f;
    const T k1 = along[1] >= 0 ? s.slabs[1].e : -s.slabs[1].f;
    const T d0 = abs(along[0]), d1 = abs(along[1]), d2 = abs(along[2]);
    const bool within0 = s.r * d0 <= k0 * length, within1 = s.r * d1 <= k1 * length;
    if (within0 && within1) return s.r * length;

    // The farthest point of the one plane's rim, unless the other plane cuts it off.
    const T rest0 = (s.r - k0) * (s.r + k0), squared2 = d2 * d2;
    if (!within0) {
        const T rim = sqrt(rest0), q = sqrt(d1 * d1 + squared2);
        if (!(d1 * rim > k1 * q)) return k0 * d0 + rim * q;
    }
    if (!within1) {
        const T rim = sqrt((s.r - k1) * (s.r + k1)), q = sqrt(d0 * d0 + squared2);
        if (!(d0 * rim > k0 * q)) return k1 * d1 + rim * q;
    }
    return k0 * d0 + k1 * d1 + d2 * sqrt(max(T(0), rest0 - k1 * k1));
}

/// Half the chord at the distance k from the center of a circle; also the radius of the circle in
/// which a plane cuts a ball. 0 if there is no cut.
inline double half_chord(double r, double k) { return std::sqrt(std::max(0.0, (r - k) * (r + k))); }

/// The areas of the faces of an Scb2.
struct Scb2Faces {
    double sphere = 0;  ///< the part of the sphere inside the slabs
    /// The parts of the planes inside the ball and the other slab: per slab, upper and lower.
    std::array<std::array<double, 2>, 2> planes{};
};

/// In closed form: the sphere's part is an integral of arcs over their height (Archimedes).
Scb2Faces faces(const Scb2& scb);

}  // namespace scb
