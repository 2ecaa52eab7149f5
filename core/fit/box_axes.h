#pragma once

#include "core/fit/fit_input.h"
#include "scb/vec.h"

namespace scb {

/// The axes of an Obb, as columns, right-handed and the longest direction first: eigenvectors of
/// the surface's scatter, of the points' where there are no triangles or they have no area, and the
/// coordinate axes where those have no direction (Gottschalk, Lin, Manocha, "OBBTree", 1996).
Mat3 box_axes(const FitInput& input);

}  // namespace scb
