#include "core/distance/body_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace scb {
namespace {

/// The rotation by an angle about a unit axis (Rodrigues' formula).
Mat3 rotation_by(const Vec3& axis, double turns) {
    const SinCos angle = sin_cos_turns(turns);
    Mat3 result;
    for (int column = 0; column < 3; ++column) {
        Vec3 unit = Vec3::Zero();
        unit[column] = 1;
        result.col(column) = angle.cos * unit + angle.sin * cross(axis, unit) +
                             (1 - angle.cos) * axis[column] * axis;
    }
    return result;
}

}  // namespace

double farthest_vertex(const Mesh& mesh) {
    double squared = 0;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            squared = std::max(squared, squared_norm(mesh.vertices[corner]));
    return std::sqrt(squared);
}

BodyMotion::BodyMotion(const Pose& from, const Pose& to)
    : from_(from), to_(to), velocity_(to.translation - from.translation) {
    const Mat3 turn = relative_pose(from, to).rotation;
    // Twice the axis times the sine, and the trace.
    const Vec3 sines(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
    const double sine = std::sqrt(squared_norm(sines)),
                 cosine = turn(0, 0) + turn(1, 1) + turn(2, 2) - 1;
    angle_ = arc_tangent(sine, std::abs(cosine));
    if (cosine < 0) angle_ = std::numbers::pi - angle_;
    if (cosine >= 0) {
        if (sine > 0) axis_ = sines / sine;
        return;
    }
    // Near half a turn the sine is inexact. The columns of R + R^T + (1 - trace) I are multiples of
    // the axis.
    Mat3 twice = turn + Mat3(turn.transpose());
    for (int i = 0; i < 3; ++i) twice(i, i) -= cosine;
    int longest = 0;
    for (int i = 1; i < 3; ++i)
        if (squared_norm(Vec3(twice.col(i))) > squared_norm(Vec3(twice.col(longest)))) longest = i;
    axis_ = twice.col(longest);
    axis_ /= std::sqrt(squared_norm(axis_));
    if (dot(axis_, sines) < 0) axis_ = -axis_;
}

Mat3 BodyMotion::rotation_at(double time) const {
    if (angle_ == 0) return from_.rotation;
    const Mat3 turn = rotation_by(axis_, time * angle_ / (2 * std::numbers::pi));
    Mat3 rotation;
    for (int column = 0; column < 3; ++column)
        rotation.col(column) = rotate(from_.rotation, Vec3(turn.col(column)));
    return rotation;
}

Pose BodyMotion::at(double time) const {
    if (time <= 0) return from_;
    if (time >= 1) return to_;
    return {rotation_at(time), from_.translation + time * velocity_};
}

double BodyMotion::last_jump(const Mesh& mesh) const {
    const Mat3 jump = to_.rotation - rotation_at(1);
    double squared = 0;
    for (int column = 0; column < 3; ++column) squared += squared_norm(Vec3(jump.col(column)));
    return std::sqrt(squared) * farthest_vertex(mesh);
}

double BodyMotion::turning_speed(const Mesh& mesh) const {
    double squared = 0;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            squared = std::max(squared, squared_norm(cross(axis_, mesh.vertices[corner])));
    // The poses are rigid to 1e-9.
    return angle_ * std::sqrt(squared) * (1 + 1e-8);
}

}  // namespace scb
