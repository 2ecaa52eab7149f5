#pragma once

#include <string>

#include "scb/pose.h"

namespace scb::golden {

/// How a body got from one pose to another, as a sentence goes on behind its name: "moved: 0.02
/// along x, 1.5 degrees", "turned: 1.5 degrees"; empty where the poses are equal. Lengths are along
/// the axes of the world, of the body's origin; what is a millionth of the rest is rounding, and is
/// left out.
std::string motion_words(const Pose& before, const Pose& after);

}  // namespace scb::golden
