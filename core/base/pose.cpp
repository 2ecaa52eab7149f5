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

void check_rigid(const Pose& pose, std::string_view name) {
    const double defect = rigidity_defect(pose);
    if (defect <= 1e-9) return;
    const std::string reason =
        std::isinf(defect)
            ? "it mirrors, is singular, or has an entry that is not finite"
            : sentence("R^T R differs from the identity by ", defect, ", 1e-9 is allowed");
    throw InputError(sentence(
        name, ": the pose is not rigid (", reason, "); give a rotation matrix with determinant 1, ",
        defect < 1e-3 ? "its numbers with 10 digits or more." : "and scale the mesh instead."));
}

}  // namespace scb
