#include <algorithm>
#include <cmath>

#include "core/explain/overlap_steps.h"
#include "core/volumes/shape.h"

namespace scb {
namespace {

/// An axis as the test compares it: not normalized. `limit` is the sum of both extents and the
/// margin, in the order of the test.
struct Axis {
    std::string name;
    Vec3 direction;
    double distance, reach_a, reach_b, limit;
};

OverlapStep axis_step(Stage stage, const Axis& axis, double margin) {
    const double distance = std::abs(axis.distance), reach = axis.reach_a + axis.reach_b;
    const double length = std::sqrt(squared_norm(axis.direction));
    const bool separates = distance > axis.limit, vanishes = !(length > (separates ? 0 : 1e-9));
    const double scale = vanishes ? 1 : length;
    OverlapStep step;
    step.stage = stage;
    step.formula = "|c1′·" + axis.name + "| > ρ0 + ρ1";
    step.left = distance / scale;
    step.right = reach / scale;
    step.separates = separates;
    const double slack = (distance - reach - margin) / scale;
    step.slack = (step.separates ? std::max(slack, 0.0) : std::min(slack, 0.0)) + 0.0;
    if (!vanishes) step.direction = (axis.distance < 0 ? -1 : 1) * axis.direction / scale;
    // The test compares both sides, which are next to nothing.
    if (vanishes) step.skipped = "the edges are parallel, so they give no axis";
    set_terms(step, {{StepTerm::Of::distance, "|c1′·" + axis.name + "|", step.left},
                     {StepTerm::Of::a, "−ρ0", -axis.reach_a / scale},
                     {StepTerm::Of::b, "−ρ1", -axis.reach_b / scale}});
    return step;
}

}  // namespace

OverlapSteps overlap_steps(const Obb& a, const Obb& b, const Placement& placed,
                           const OverlapOptions&) {
    const Vec3 offset = transform_point(placed.b_to_a, b.center) - a.center;
    OverlapSteps result;
    result.margin = placed.margin;
    result.quantities = {
        {"‖c1′‖", "distance", "distance of the centers", std::sqrt(squared_norm(offset))}};
    Mat3 turned, r, s;
    Vec3 t;
    for (int j = 0; j < 3; ++j)
        turned.col(j) = transform_direction(placed.b_to_a, Vec3(b.axes.col(j)));
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = a.axes.col(i);
        t[i] = dot(axis, offset);
        for (int j = 0; j < 3; ++j) {
            r(i, j) = dot(axis, Vec3(turned.col(j)));
            s(i, j) = std::abs(r(i, j));
        }
    }
    const Vec3 &ha = a.half, &hb = b.half;
    const double margin = placed.margin;
    const auto name = [](char box, int i) { return std::string(1, box) + std::to_string(i); };
    const auto add = [&](Stage first, int i, const Axis& axis) {
        const auto stage = static_cast<Stage>(static_cast<int>(first) + i);
        result.steps.push_back(axis_step(stage, axis, margin));
    };
    for (int i = 0; i < 3; ++i) {
        const double b0 = hb[0] * s(i, 0), b1 = hb[1] * s(i, 1), b2 = hb[2] * s(i, 2);
        add(Stage::axis_a0, i,
            {name('a', i), a.axes.col(i), t[i], ha[i], b0 + b1 + b2,
             ha[i] + b0 + b1 + b2 + margin});
    }
    for (int j = 0; j < 3; ++j) {
        const double a0 = ha[0] * s(0, j), a1 = ha[1] * s(1, j), a2 = ha[2] * s(2, j);
        add(Stage::axis_b0, j,
            {name('b', j), turned.col(j), t[0] * r(0, j) + t[1] * r(1, j) + t[2] * r(2, j),
             a0 + a1 + a2, hb[j], hb[j] + a0 + a1 + a2 + margin});
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double a1 = ha[i1] * s(i2, j), a2 = ha[i2] * s(i1, j);
            const double b1 = hb[j1] * s(i, j2), b2 = hb[j2] * s(i, j1);
            add(Stage::axis_a0_b0, 3 * i + j,
                {"(" + name('a', i) + "×" + name('b', j) + ")",
                 cross(Vec3(a.axes.col(i)), Vec3(turned.col(j))),
                 t[i2] * r(i1, j) - t[i1] * r(i2, j), a1 + a2, b1 + b2,
                 a1 + a2 + b1 + b2 + margin});
        }
    return result;
}

// Products with a unit axis of the frame are its component, to the last bit.
OverlapSteps overlap_steps(const Aabb& a, const Aabb& b, const Placement& placed,
                           const OverlapOptions& options) {
    OverlapSteps result = overlap_steps(shape_of(a), shape_of(b), placed, options);
    result.steps.resize(aabb_stages().size());
    return result;
}

OverlapSteps overlap_steps(const ExactAabb& a, const ExactAabb& b, const Placement& placed,
                           const OverlapOptions& options) {
    return overlap_steps(shape_of(a), shape_of(b), placed, options);
}

}  // namespace scb
