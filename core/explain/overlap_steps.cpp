#include "core/explain/overlap_steps.h"

#include <algorithm>
#include <cmath>

namespace scb {

std::optional<std::size_t> OverlapSteps::decisive() const {
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (steps[i].skipped.empty() && steps[i].separates) return i;
    return std::nullopt;
}

Stage OverlapSteps::stage() const {
    const std::optional<std::size_t> i = decisive();
    return i ? steps[*i].stage : Stage::overlapping;
}

std::size_t OverlapSteps::closest() const {
    if (const std::optional<std::size_t> i = decisive()) return *i;
    std::size_t best = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (steps[i].skipped.empty() && steps[i].slack > steps[best].slack) best = i;
    return best;
}

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

void set_terms(OverlapStep& step, std::vector<StepTerm> terms) {
    step.reach_a = step.reach_b = 0;
    for (const StepTerm& term : terms)
        if (term.of != StepTerm::Of::distance)
            (term.of == StepTerm::Of::a ? step.reach_a : step.reach_b) -= term.value;
    step.terms = std::move(terms);
}

StepTerm slab_distance(bool above, const std::string& name, double d) {
    return {StepTerm::Of::distance, (above ? "" : "−") + name, above ? d : -d};
}

StepTerm slab_plane(bool of_a, bool above, const std::string& name, double at) {
    return {of_a ? StepTerm::Of::a : StepTerm::Of::b, (above ? "−" : "+") + name, above ? -at : at};
}

OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum) {
    const double distance = std::sqrt(squared_norm(c));
    OverlapStep step = comparison(Stage::ball_ball, 2, "‖c1′‖ > r0 + r1", distance, r0 + r1,
                                  distance - (r0 + r1) - margin, squared_norm(c) > sum * sum);
    if (distance > 0) step.direction = c / distance;
    set_terms(step, {{StepTerm::Of::distance, "‖c1′‖", distance},
                     {StepTerm::Of::a, "−r0", -r0},
                     {StepTerm::Of::b, "−r1", -r1}});
    return step;
}

}  // namespace scb
