#pragma once

#include <string>

#include "core/explain/overlap_steps.h"

namespace scb {

/// One comparison. -0 becomes 0, and a slack with a wrong sign because of rounding becomes 0.
OverlapStep comparison(Stage stage, int line, std::string formula, double left, double right,
                       double slack, bool separates);

/// Sets the terms, and the extents that they add up to.
void set_terms(OverlapStep& step, std::vector<StepTerm> terms);

/// The terms of the distance d from a slab to the other's center, and of the slab's plane that is
/// `above` it or below: "d0" and "−e0", "−d0" and "+f0".
StepTerm slab_distance(bool above, const std::string& name, double d);
StepTerm slab_plane(bool of_a, bool above, const std::string& name, double at);

/// The step of the balls. `sum` is the sum of the radii and the margin, in the order in which the
/// test adds them.
OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum);

}  // namespace scb
