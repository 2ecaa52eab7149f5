#pragma once

#include <Eigen/Core>

namespace scb {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Products in one stated order of operations, so that every compiler rounds it alike.
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double squared_norm(const Vec3& a) { return dot(a, a); }

}  // namespace scb
