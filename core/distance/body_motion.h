#pragma once

#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb {

/// The motion of a body from one pose to another, in the time from 0 to 1: its origin moves on a
/// straight line, and the body turns about its origin by less than half a turn, both at constant
/// speed. At exactly half a turn the axis is one of two that are opposite.
class BodyMotion {
  public:
    /// The poses must be rigid, see check_rigid.
    BodyMotion(const Pose& from, const Pose& to);

    /// The pose at a time; at 0 and 1 exactly the given ones. Computed with operations that
    /// IEEE 754 fixes.
    Pose at(double time) const;

    const Vec3& velocity() const { return velocity_; }
    /// The angle, in radians.
    double angle() const { return angle_; }
    /// The largest speed that the rotation gives a vertex, or more: the angle times the distance of
    /// the farthest vertex from the axis.
    double turning_speed(const Mesh& mesh) const;
    /// How far a vertex may jump when the motion ends at the given pose, since poses are rigid to
    /// 1e-9 only.
    double last_jump(const Mesh& mesh) const;

  private:
    /// The rotation at a time before the end.
    Mat3 rotation_at(double time) const;

    Pose from_, to_;
    Vec3 velocity_, axis_ = Vec3::Zero();  ///< the axis in the frame of the body
    double angle_ = 0;
};

/// The distance of the farthest corner of a triangle from the origin.
double farthest_vertex(const Mesh& mesh);

}  // namespace scb
