#include "scb/pose.h"

#include <cmath>
#include <limits>

#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb {

Pose relative_pose(const Pose& a, const Pose& b) {
    Pose result;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = a.rotation.col(i);
        for (int j = 0; j < 3; ++j) result.rotation(i, j) = dot(axis, Vec3(b.rotation.col(j)));
        result.translation[i] = dot(axis, Vec3(b.translation - a.translation));
    }
    return result;
}

double rigidity_defect(const Pose& pose) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!pose.rotation.allFinite() || !pose.translation.allFinite()) return infinity;
    const Mat3& r = pose.rotation;
    const Vec3 x = r.col(0), y = r.col(1), z = r.col(2);
    if (!(dot(cross(x, y), z) > 0)) return infinity;
    double defect = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            defect = std::max(defect,
                              std::abs(dot(Vec3(r.col(i)), Vec3(r.col(j))) - (i == j ? 1.0 : 0.0)));
    return defect;
}

namespace {

/// Defects that are no larger are rounding; beyond the second, a pose is no rotation.
constexpr double rounding = 1e-9, nearly_rigid = 1e-3;

[[noreturn]] void refuse(double defect, const char* allowed, std::string_view name) {
    const std::string reason =
        std::isinf(defect)
            ? "it mirrors, is singular, or has an entry that is not finite"
            : sentence("R^T R differs from the identity by ", defect, ", ", allowed, " is allowed");
    throw InputError(sentence(name, ": the pose is not rigid (", reason,
                              "); give a rotation matrix with determinant 1, ",
                              defect <= nearly_rigid ? "its numbers with 10 digits or more."
                                                     : "and scale the mesh instead."));
}

}  // namespace

void check_rigid(const Pose& pose, std::string_view name) {
    const double defect = rigidity_defect(pose);
    if (!(defect <= rounding)) refuse(defect, "1e-9", name);
}

NearestPose nearest_rigid(const Pose& pose, std::string_view name) {
    const double defect = rigidity_defect(pose);
    if (defect <= rounding) return {pose, 0};
    if (!(defect <= nearly_rigid)) refuse(defect, "1e-3", name);
    NearestPose nearest{pose, 0};
    Mat3& r = nearest.pose.rotation;
    // Each step squares the error, 1e-3 at first. The last one removes the rounding of the others.
    for (int step = 0; step < 4; ++step) {
        const Vec3 x = r.col(0), y = r.col(1), z = r.col(2);
        const double determinant = dot(cross(x, y), z);
        const Vec3 columns[3] = {cross(y, z), cross(z, x),
                                 cross(x, y)};  // of the inverse transposed
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i) r(i, k) = (r(i, k) + columns[k][i] / determinant) / 2;
    }
    nearest.correction = (r - pose.rotation).cwiseAbs().maxCoeff();
    return nearest;
}

}  // namespace scb
