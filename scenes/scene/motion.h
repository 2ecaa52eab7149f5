#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scb/pose.h"

namespace scb::scenes {

/// A rotation about an axis through the origin of the body frame: by `degrees + degrees_per_frame *
/// frame`, counterclockwise seen from the tip of the axis. The axis need not be a unit vector, but
/// must not be zero.
struct Turn {
    Vec3 axis = Vec3::UnitZ();
    double degrees = 0;
    double degrees_per_frame = 0;
};

/// A straight path of the body's origin in the world, in scene units: `from + (to - from) * (frame
/// / frames)`. It continues beyond `frames` at the same speed.
struct LinearPath {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double frames = 1;  ///< > 0
};

/// The pose of a body from a frame on.
struct PoseKey {
    int frame = 0;
    Pose pose;
};

/// How a body moves. Matrices act on columns; the body is first turned by `base`, then by each of
/// `turns` in the order of the list, then moved along `path`. Euler angles are three turns about x,
/// y and z.
struct Motion {
    LinearPath path;
    Mat3 base = Mat3::Identity();
    std::vector<Turn> turns;
    /// How much `base` differs from the matrix that was given: see nearest_rigid.
    double correction = 0;
    /// Replaces all other members: given poses, ascending by frame; the first is also valid for
    /// earlier frames.
    std::vector<PoseKey> told;
    /// The log with these poses, see PoseLogs, and the line of the pose that was corrected most.
    std::filesystem::path log;
    std::size_t corrected_line = 0;
};

/// The rotation by `degrees` about `axis`: Rodrigues' formula, with no function of the C library
/// whose rounding depends on the machine. Throws InputError if the axis is zero or a number is not
/// finite.
Mat3 rotation_about(const Vec3& axis, double degrees);

/// This pose or, unless `exact`, the pose with the nearest rotation. Throws InputError, naming
/// `name`, as check_rigid and nearest_rigid do.
NearestPose rigid_pose(const Pose& pose, bool exact, const std::string& name);

/// A body that rests at the rigid_pose.
Motion resting_at(const Pose& pose, bool exact, const std::string& name);

/// The pose (body frame to world) at a frame. Throws InputError if the pose is not rigid and
/// finite, see check_rigid.
Pose pose_at(const Motion& motion, int frame);

}  // namespace scb::scenes
