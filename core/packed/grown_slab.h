#pragma once

#include <array>

#include "scb/scb2.h"
#include "scb/vec.h"

namespace scb {

/// The smallest float that is no less than `value`, which may be infinity.
float float_above(double value);

/// An upper bound of the rounding of a point relative to the origin, and of a center: some units in
/// the last place of the coordinates. It does not depend on the radius, which may be 0.
double blur_of(const Vec3& c, const Vec3& origin);

/// A ball about a center that a storage format has rounded. The radius and slabs have to grow by
/// the difference.
struct MovedBall {
    Vec3 shift;   ///< from the rounded center to its own
    double blur;  ///< see blur_of
    double r;     ///< the radius that it needs there, larger by a relative 2^-40

    /// `rounded` is the stored center, and `origin` the origin that it is stored relative to; all
    /// in the frame of the ball.
    MovedBall(const Vec3& c, double radius, const Vec3& rounded, const Vec3& origin);
};

/// The middle and half thickness that a slab needs about another center and normal. The half
/// thickness is larger by 2^-40 of the radius, and by the blur.
struct GrownSlab {
    double m, h;

    /// The slab f <= n.(x - c) <= e of the ball, about the rounded normal.
    GrownSlab(const Vec3& n, double e, double f, const Vec3& rounded, const MovedBall& ball);

    /// Half the thickness that contains the slab if its middle is rounded to `middle`.
    double half_about(double middle) const;
};

/// The slabs of an Scb2 for PackedScb2, not rounded yet: the narrower slab first, the normals
/// turned around such that the scalar part of the quaternion is the largest.
struct TurnedSlabs {
    std::array<Slab, 2> slabs;
    Vec3 q;  ///< the vector part; no component is larger than the scalar part

    explicit TurnedSlabs(const Scb2& scb);
};

}  // namespace scb
