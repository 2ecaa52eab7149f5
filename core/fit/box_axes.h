#pragma once

#include "core/fit/fit_input.h"
#include "scb/vec.h"

namespace scb {

/// The axes of an Obb, as columns, right-handed and the longest direction first: eigenvectors of
/// the scatter of the surface, or of the points if there are no triangles or they have no area; the
/// coordinate axes if the points' scatter has no direction (Gottschalk, Lin, Manocha, "OBBTree",
/// 1996).
Mat3 box_axes(const FitInput& input);

}  // namespace scb
