#pragma once

#include <string>

#include "core/explain/overlap_steps.h"

namespace scb {

/// One comparison, with the rules for zeros and for a slack that rounding gives the wrong sign.
OverlapStep comparison(Stage stage, int line, std::string formula, double left, double right,
                       double slack, bool separates);

/// The balls. `sum` is that of the radii and the margin, in the order in which the test adds them.
OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum);

}  // namespace scb
