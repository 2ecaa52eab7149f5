#pragma once

#include <string>

#include "core/explain/overlap_steps.h"

namespace scb {

/// One comparison, with the rules for zeros and for a slack that rounding gives the wrong sign.
OverlapStep comparison(Stage stage, int line, std::string formula, double left, double right,
                       double slack, bool separates);

/// Sets them, and the reaches that they add up to.
void set_terms(OverlapStep& step, std::vector<StepTerm> terms);

/// Of the distance d from a slab to the other's center, and of the slab's plane that is `above` it
/// or below: "d0" and "−e0", "−d0" and "+f0".
StepTerm slab_distance(bool above, const std::string& name, double d);
StepTerm slab_plane(bool of_a, bool above, const std::string& name, double at);

/// The balls. `sum` is that of the radii and the margin, in the order in which the test adds them.
OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum);

}  // namespace scb
