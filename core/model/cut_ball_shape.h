#pragma once

#include "core/volumes/convex_shape.h"
#include "scb/scb2.h"

namespace scb {

/// A ball cut by two slabs, by its support points. They are exact if the center of the ball is in
/// both slabs.
ConvexShape cut_ball_shape(const Scb2& scb);

}  // namespace scb
