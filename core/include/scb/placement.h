#pragma once

#include "scb/pose.h"
#include "scb/volume.h"

namespace scb {

/// The pose of B in A's frame, and a bound of how far rounding may move points of B there. An
/// overlap test that rejects only gaps above `margin` never separates two sets that touch, in spite
/// of rounding. T is the scalar type, see BasicScb.
template <class T>
struct BasicPlacement {
    /// Takes B's frame to A's.
    BasicPose<T> b_to_a;
    T margin = 0;  ///< a length
    /// Slightly above 1: this minus the squared cosine of two unit normals, one of them
    /// transformed, is never below their squared sine. `1 - cosine^2` cancels if slabs are nearly
    /// parallel.
    T squared_sine_bound = 1;
};
/// In doubles.
using Placement = BasicPlacement<double>;

/// The placement for everything within the distance `reach_a` of the origin of A's frame and
/// `reach_b` of the origin of B's frame. The margin is some 1e-14 of the sum of the two reaches and
/// the translation, and larger if the pose is not rigid to the last bit.
Placement placement(const Pose& b_to_a, double reach_a, double reach_b);

/// A distance from the origin of the body's frame that no point of the volume exceeds.
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
