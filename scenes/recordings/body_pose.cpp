#include "scenes/recordings/body_pose.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"
#include "core/judge/engine_query.h"
#include "core/judge/mapped_volume.h"

namespace scb::scenes {
namespace {

/// A pose with a smaller defect is rigid in 64-bit numbers.
constexpr double double_defect = 1e-12;
/// A pose with a larger defect stretches its body: see rigidity_defect.
constexpr double most_defect = 1e-4;
/// A pose with a smaller determinant, relative to the cube of its longest column, is invalid.
constexpr double most_flat = 1e-9;

/// The pose made rigid up to rounding: columns become unit vectors at right angles, and the first
/// keeps its direction.
Pose made_rigid(Pose pose) {
    Vec3 x = pose.rotation.col(0), y = pose.rotation.col(1);
    x /= std::sqrt(squared_norm(x));
    y -= dot(x, y) * x;
    y /= std::sqrt(squared_norm(y));
    pose.rotation.col(0) = x;
    pose.rotation.col(1) = y;
    pose.rotation.col(2) = cross(x, y);
    return pose;
}

}  // namespace

BodyPose body_pose(const Pose& told) {
    BodyPose body;
    body.pose.translation = told.translation;
    body.is_finite = told.rotation.allFinite() && told.translation.allFinite();
    if (!body.is_finite || !is_usable(told.translation)) {
        body.pose = Pose{};
        body.pose_fault = body.is_finite ? "is beyond 1e70" : "is not finite";
        return body;
    }
    Vec3 lengths;
    for (int i = 0; i < 3; ++i) lengths[i] = std::sqrt(squared_norm(Vec3(told.rotation.col(i))));
    Pose rigid = told;
    double defect = rigidity_defect(told);
    if (!(defect <= most_defect)) {
        Vec3 scales = lengths;
        if (determinant(told.rotation) < 0) scales[0] = -scales[0];
        // Scales that are equal up to the engine's rounding become one scale.
        if ((scales.cwiseAbs().array() - lengths[0]).abs().maxCoeff() <= most_defect * lengths[0])
            scales = scales.cwiseSign() * lengths[0];
        for (int i = 0; i < 3; ++i) rigid.rotation.col(i) /= scales[i];
        defect = rigidity_defect(rigid);
        if (!(std::abs(determinant(told.rotation)) >
              most_flat * lengths.maxCoeff() * lengths.maxCoeff() * lengths.maxCoeff())) {
            body.pose_fault = "makes the body flat";
            return body;
        }
        if (!(defect <= most_defect)) {
            body.stretch = told.rotation;
            return body;
        }
        body.stretch = Mat3(scales.asDiagonal());
    }
    body.defect = defect;
    body.pose = defect > double_defect ? made_rigid(rigid) : rigid;
    return body;
}

std::string stretch_words(const Mat3& stretch) {
    if (!stretch.isDiagonal()) return "sheared";
    const Vec3 scales = stretch.diagonal().cwiseAbs();
    std::string words;
    if (scales[0] == scales[1] && scales[0] == scales[2]) {
        if (scales[0] != 1) words = "scaled by " + format("%.6g", scales[0]);
    } else {
        words = format("scaled by %.6g, ", scales[0]) + format("%.6g and ", scales[1]) +
                format("%.6g", scales[2]);
    }
    if (determinant(stretch) < 0) words += words.empty() ? "mirrored" : " and mirrored";
    return words;
}

}  // namespace scb::scenes
