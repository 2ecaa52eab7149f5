#pragma once

#include "scb/vec.h"

namespace scb {

/// The smallest float that is no less than `value`, which may be infinity.
float float_above(double value);

/// How far a point is moved at most by rounding where it is seen from the origin, and a center by
/// its rounding: some units in the last place of the coordinates, whatever the radius, which may be
/// 0.
double blur_of(const Vec3& c, const Vec3& origin);

/// A ball about another center than its own, as a storage format rounds it: the rest has to make up
/// for that.
struct MovedBall {
    Vec3 shift;   ///< from there to its own center
    double blur;  ///< see blur_of
    double r;     ///< that it needs there, larger by a relative 2^-40

    /// `rounded` is the center where the ball is stored, `origin` what that is stored relative to;
    /// all in the frame of the ball.
    MovedBall(const Vec3& c, double radius, const Vec3& rounded, const Vec3& origin);
};

/// Middle and half thickness that a slab needs about another center and normal. Larger than that by
/// a relative 2^-40 of the radius, and by the blur.
struct GrownSlab {
    double m, h;

    /// The slab f <= n.(x - c) <= e of the ball, about the rounded normal.
    GrownSlab(const Vec3& n, double e, double f, const Vec3& rounded, const MovedBall& ball);

    /// Half the thickness that holds the slab where its middle is rounded to `middle`.
    double half_about(double middle) const;
};

}  // namespace scb
