#pragma once

#include "scb/pose.h"
#include "scb/volume.h"

namespace scb {

/// Where B is, seen from A's frame, and how far rounding may have moved anything of B there. An
/// overlap test that leaves `margin` between what it separates never separates two sets that touch,
/// however it is rounded. T is the scalar type, see BasicScb.
template <class T>
struct BasicPlacement {
    /// Takes B's frame to A's.
    BasicPose<T> b_to_a;
    T margin = 0;  ///< a length
    /// 1, and so much more that this less the square of the cosine of two unit normals, one of them
    /// transformed, is never below the square of their sine: `1 - cosine^2` cancels where slabs are
    /// nearly parallel.
    T squared_sine_bound = 1;
};
/// In doubles.
using Placement = BasicPlacement<double>;

/// The placement for everything within the distance `reach_a` of the origin of A's frame and
/// `reach_b` of the origin of B's frame. The margin is some 1e-14 of the three lengths that meet:
/// the two reaches and the translation; more where the pose is not rigid to the last bit.
Placement placement(const Pose& b_to_a, double reach_a, double reach_b);

/// The distance from the origin of the body's frame within which the volume is.
double reach(const Scb& v);
/// The same.
double reach(const Scb2& v);
/// The same.
double reach(const Ball& v);
/// The same.
double reach(const Obb& v);
/// The same.
double reach(const Aabb& v);
/// The same.
double reach(const ExactAabb& v);

}  // namespace scb
