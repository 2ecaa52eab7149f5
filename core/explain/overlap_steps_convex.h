#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/explain/overlap_steps.h"
#include "core/overlap/overlap_convex.h"

namespace scb {

/// The directions of overlap_convex, each of them a step; u is the direction from A's center to
/// B's, w the direction of a step of the search.
template <ConvexVolume V>
OverlapSteps overlap_steps(const V& a, const V& b, const Placement& placed,
                           const OverlapOptions& = {}) {
    struct Tried {
        Stage stage;
        Vec3 direction, farthest;
    };
    std::vector<Tried> tried;
    const Stage end = overlap_convex(a, b, placed, [&](Stage stage, const Vec3& d, const Vec3& w) {
        tried.push_back({stage, d, w});
    });
    const Vec3 to_b = transform_point(placed.b_to_a, center(b)) - center(a);
    OverlapSteps result;
    result.margin = placed.margin;
    result.quantities = {
        {"‖c1′‖", "distance", "distance of the centers", std::sqrt(squared_norm(to_b))}};
    for (std::size_t i = 0; i < tried.size(); ++i) {
        const double length = std::sqrt(squared_norm(tried[i].direction));
        const Vec3 unit = tried[i].direction / length;
        const std::string name = i == 0 ? "u" : "w" + std::to_string(i);
        const double distance = dot(unit, to_b);
        const double apart = -dot(unit, tried[i].farthest) - rounding(a) - rounding(b);
        OverlapStep step =
            comparison(tried[i].stage, 0, "c1′·" + name + " > ρ0 + ρ1", distance, distance - apart,
                       apart - placed.margin, i + 1 == tried.size() && end != Stage::overlapping);
        step.direction = unit;
        const double reach_a = support(a, unit);
        set_terms(step, {{StepTerm::Of::distance, "c1′·" + name, distance},
                         {StepTerm::Of::a, "−ρ0", -reach_a},
                         {StepTerm::Of::b, "−ρ1", reach_a - step.right}});
        result.steps.push_back(std::move(step));
    }
    return result;
}

}  // namespace scb
