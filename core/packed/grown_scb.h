#pragma once

#include "scb/scb.h"

namespace scb {

/// The smallest float that is no less than `value`, which must be below the largest float.
float float_above(double value);

/// What of an SCB a storage format keeps as it is, after rounding: the rest has to make up for it.
struct RoundedCenter {
    Vec3 c;  ///< in the frame of the SCB that is rounded
    Vec3 n;
    Vec3 origin;  ///< in that frame: what the center is stored relative to
};

/// How far a point is moved at most by rounding where it is seen from the origin, and the center by
/// its rounding: some units in the last place of the coordinates, whatever the radius, which may be
/// 0.
double blur_of(const Scb& scb, const Vec3& origin);

/// Radius, middle and half thickness that an SCB needs about another center and normal. Larger than
/// that by a relative 2^-40, and by blur_of.
struct GrownScb {
    double r, m, h;
};
GrownScb grown_about(const Scb& scb, const RoundedCenter& rounded);

/// Half the thickness that holds the slab where its middle is rounded to `m`.
double half_thickness(const GrownScb& grown, double m);

}  // namespace scb
