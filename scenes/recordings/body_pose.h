#pragma once

#include <string>

#include "scb/pose.h"

namespace scb::scenes {

/// A recorded pose, which may scale, mirror or shear its body: a stretch in the body's frame,
/// followed by a rigid pose.
struct BodyPose {
    Pose pose;                        ///< from the stretched body to the world: rigid
    Mat3 stretch = Mat3::Identity();  ///< along the body's axes if possible
    double defect = 0;       ///< deviation of the recorded pose from these two, see rigidity_defect
    std::string pose_fault;  ///< why the pose is invalid: "is not finite"; empty: valid
    bool is_finite = true;

    bool is_stretched() const { return stretch != Mat3::Identity(); }
};

/// Takes any matrix. A pose of rounded numbers becomes the rigid pose that it stands for.
BodyPose body_pose(const Pose& told);

/// "scaled by 2", "mirrored", "scaled by 1, 2 and 3", "sheared".
std::string stretch_words(const Mat3& stretch);

}  // namespace scb::scenes
