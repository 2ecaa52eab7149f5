#pragma once

#include <algorithm>
#include <cmath>

namespace scb {

/// Half the chord at the distance k from the center of a circle; also the radius of the circle in
/// which a plane cuts a ball. 0 if there is no cut.
inline double half_chord(double r, double k) { return std::sqrt(std::max(0.0, (r - k) * (r + k))); }

}  // namespace scb
