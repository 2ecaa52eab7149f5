#pragma once

#include <Eigen/Core>

namespace scb {

/// A column of three numbers.
template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
/// A 3 x 3 matrix.
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
/// A point, a direction or a displacement, in doubles.
using Vec3 = Vector3<double>;
/// A 3 x 3 matrix of doubles.
using Mat3 = Matrix3<double>;

/// The scalar product. Like the functions below, it has one stated order of operations, so that
/// every compiler rounds it alike.
template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The vector product.
template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The square of the length.
template <class T>
T squared_norm(const Vector3<T>& a) {
    return dot(a, a);
}

/// For doubles, and for Eigen's expressions, from which templates cannot deduce T.
inline double dot(const Vec3& a, const Vec3& b) { return dot<double>(a, b); }
/// For doubles, likewise.
inline Vec3 cross(const Vec3& a, const Vec3& b) { return cross<double>(a, b); }
/// For doubles, likewise.
inline double squared_norm(const Vec3& a) { return squared_norm<double>(a); }

}  // namespace scb
