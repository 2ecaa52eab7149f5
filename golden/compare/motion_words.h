#pragma once

#include <string>

#include "scb/pose.h"

namespace scb::golden {

/// The motion of a body between two poses, as words behind its name: "moved: 0.02 along x, 1.5
/// degrees", "turned: 1.5 degrees"; empty if the poses are equal. Lengths are the motion of the
/// body's origin along the axes of the world. Parts below a millionth of the rest are rounding, and
/// are left out.
std::string motion_words(const Pose& before, const Pose& after);

}  // namespace scb::golden
