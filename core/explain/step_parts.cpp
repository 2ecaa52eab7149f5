#include "core/explain/step_parts.h"

#include <algorithm>
#include <cmath>

namespace scb {

OverlapStep comparison(Stage stage, int line, std::string formula, double left, double right,
                       double slack, bool separates) {
    OverlapStep step;
    step.stage = stage;
    step.line = line;
    step.formula = std::move(formula);
    step.left = left + 0.0;  // -0 is 0
    step.right = right + 0.0;
    step.slack = (separates ? std::max(slack, 0.0) : std::min(slack, 0.0)) + 0.0;
    step.separates = separates;
    return step;
}

OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum) {
    const double distance = std::sqrt(squared_norm(c));
    OverlapStep step = comparison(Stage::ball_ball, 2, "‖c1′‖ > r0 + r1", distance, r0 + r1,
                                  distance - (r0 + r1) - margin, squared_norm(c) > sum * sum);
    if (distance > 0) step.direction = c / distance;
    step.reach_a = r0;
    step.reach_b = r1;
    step.name_a = "r0";
    step.name_b = "r1";
    return step;
}

}  // namespace scb
