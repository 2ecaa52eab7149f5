#include "scenes/scene/motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/portable_math.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

/// The product in one stated order of operations.
Mat3 product(const Mat3& a, const Mat3& b) {
    Mat3 result;
    for (int j = 0; j < 3; ++j) result.col(j) = rotate(a, Vec3(b.col(j)));
    return result;
}

}  // namespace

Mat3 rotation_about(const Vec3& axis, double degrees) {
    const double largest = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
    if (!(largest > 0) || !axis.allFinite())
        throw InputError(
            "an axis of rotation is zero or not finite; give three numbers, not all zero.");
    if (!std::isfinite(degrees))
        throw InputError("an angle of rotation is not finite; give a number of degrees.");
    // Dividing by the largest entry first keeps the squares of very small and very large axes in
    // range.
    const Vec3 scaled = axis / largest;
    const Vec3 u = scaled / std::sqrt(squared_norm(scaled));
    const SinCos angle = sin_cos_degrees(degrees);
    const double s = angle.sin, c = angle.cos, k = 1 - c;
    Mat3 m;
    m << c + k * u[0] * u[0], k * u[0] * u[1] - s * u[2], k * u[0] * u[2] + s * u[1],  //
        k * u[1] * u[0] + s * u[2], c + k * u[1] * u[1], k * u[1] * u[2] - s * u[0],   //
        k * u[2] * u[0] - s * u[1], k * u[2] * u[1] + s * u[0], c + k * u[2] * u[2];
    return m;
}

NearestPose rigid_pose(const Pose& pose, bool exact, const std::string& name) {
    if (exact) check_rigid(pose, name);
    return nearest_rigid(pose, name);
}

Motion resting_at(const Pose& pose, bool exact, const std::string& name) {
    const NearestPose nearest = rigid_pose(pose, exact, name);
    Motion motion;
    motion.base = nearest.pose.rotation;
    motion.correction = nearest.correction;
    motion.path.from = motion.path.to = nearest.pose.translation;
    return motion;
}

Pose pose_at(const Motion& motion, int frame) {
    if (!motion.told.empty()) {
        const auto next = std::upper_bound(motion.told.begin(), motion.told.end(), frame,
                                           [](int f, const PoseKey& key) { return f < key.frame; });
        return next == motion.told.begin() ? next->pose : std::prev(next)->pose;
    }
    Pose pose;
    pose.rotation = motion.base;
    for (const Turn& turn : motion.turns)
        pose.rotation =
            product(rotation_about(turn.axis, turn.degrees + turn.degrees_per_frame * frame),
                    pose.rotation);
    const LinearPath& path = motion.path;
    pose.translation = path.from + (path.to - path.from) * (frame / path.frames);
    check_rigid(pose, "the motion at frame " + std::to_string(frame));
    return pose;
}

}  // namespace scb::scenes
