#pragma once

#include <algorithm>
#include <cmath>

namespace scb {

/// Half the chord at the distance k from the center of a circle, and the radius of the rim in which
/// a plane cuts a ball; 0 where it misses.
inline double half_chord(double r, double k) { return std::sqrt(std::max(0.0, (r - k) * (r + k))); }

}  // namespace scb
