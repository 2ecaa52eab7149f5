#pragma once

#include <string>

#include "scb/pose.h"

namespace scb::scenes {

/// A pose that an engine recorded, which may scale, mirror or shear its body: a rigid pose after a
/// stretch in the body's own frame.
struct BodyPose {
    Pose pose;                        ///< from the stretched body to the world: rigid
    Mat3 stretch = Mat3::Identity();  ///< along the body's axes where that is possible
    double defect = 0;                ///< how far the recorded pose is from these two
    std::string pose_fault;           ///< why there is none: "is not finite"; empty: there is one
    bool is_finite = true;

    bool is_stretched() const { return stretch != Mat3::Identity(); }
};

/// Of any matrix; numbers of 32 bits are rounded to the rigid pose that they stand for.
BodyPose body_pose(const Pose& told);

/// "scaled by 2", "mirrored", "scaled by 1, 2 and 3", "sheared".
std::string stretch_words(const Mat3& stretch);

}  // namespace scb::scenes
