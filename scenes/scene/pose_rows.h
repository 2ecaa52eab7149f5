#pragma once

#include <array>

#include "scb/pose.h"

namespace scb::scenes {

/// A pose as in files, --pose and logs: the matrix [R|t], row by row.
using PoseRows = std::array<double, 12>;

PoseRows rows_of(const Pose& pose);
Pose pose_of(const PoseRows& rows);

}  // namespace scb::scenes
