#pragma once

#include <string_view>

#include "scb/vec.h"

namespace scb {

/// A rigid placement of a body: body frame to world frame, `x -> rotation * x + translation`. T is
/// the scalar type: double, or one that counts its operations.
template <class T>
struct BasicPose {
    /// Orthonormal, with determinant 1; acts on columns.
    Matrix3<T> rotation = Matrix3<T>::Identity();
    /// Where the origin of the body is, in the unit of the mesh.
    Vector3<T> translation = Vector3<T>::Zero();
};
/// In doubles.
using Pose = BasicPose<double>;

/// The product m v, in one stated order of operations.
template <class T>
Vector3<T> rotate(const Matrix3<T>& m, const Vector3<T>& v) {
    return {m(0, 0) * v[0] + m(0, 1) * v[1] + m(0, 2) * v[2],
            m(1, 0) * v[0] + m(1, 1) * v[1] + m(1, 2) * v[2],
            m(2, 0) * v[0] + m(2, 1) * v[1] + m(2, 2) * v[2]};
}

/// A point of the body, in the world.
template <class T>
Vector3<T> transform_point(const BasicPose<T>& pose, const Vector3<T>& point) {
    return rotate(pose.rotation, point) + pose.translation;
}

/// A direction of the body, in the world.
template <class T>
Vector3<T> transform_direction(const BasicPose<T>& pose, const Vector3<T>& direction) {
    return rotate(pose.rotation, direction);
}

/// For doubles, and for Eigen's expressions, from which templates cannot deduce T.
inline Vec3 rotate(const Mat3& m, const Vec3& v) { return rotate<double>(m, v); }
/// For doubles, likewise.
inline Vec3 transform_point(const Pose& pose, const Vec3& point) {
    return transform_point<double>(pose, point);
}
/// For doubles, likewise.
inline Vec3 transform_direction(const Pose& pose, const Vec3& direction) {
    return transform_direction<double>(pose, direction);
}

/// The pose of B as seen from A's frame: `inverse(a) * b` (equation 6 of the paper).
Pose relative_pose(const Pose& a, const Pose& b);

/// The inverse: of the pose of B in A's frame, the pose of A in B's.
inline Pose inverse(const Pose& pose) { return relative_pose(pose, Pose{}); }

/// The largest entry of |R^T R - I|, or infinity where the determinant is not positive or an entry
/// is not finite.
double rigidity_defect(const Pose& pose);

/// Throws InputError where the pose is not rigid to 1e-9: a scaled or mirrored pose would silently
/// break radii and normals. `name` says whose pose it is.
void check_rigid(const Pose& pose, std::string_view name);

/// A pose whose rotation was replaced by the nearest one.
struct NearestPose {
    Pose pose;              ///< rigid
    double correction = 0;  ///< the largest change of an entry; 0: nothing was replaced
};

/// The pose with the nearest rotation, for numbers of single precision or few digits: the
/// orthogonal polar factor, by Newton's iteration (Higham, "Computing the Polar Decomposition—with
/// Applications", 1986, equation 3.1). A pose that is rigid to 1e-9 stays as it is. Throws
/// InputError, as check_rigid does, if |R^T R - I| has an entry above 1e-3.
NearestPose nearest_rigid(const Pose& pose, std::string_view name);

}  // namespace scb
