#pragma once

#include "core/extremal_points.h"
#include "core/fit.h"

namespace scb {

/// Lines 1 to 6 of Figure 3: the ball of an SCB, and of a ball hierarchy. `extremal` are the points
/// of `input.dop`.
Ball enclosing_ball(const FitInput& input, const ExtremalPoints& extremal,
                    const FitOptions& options);

}  // namespace scb
