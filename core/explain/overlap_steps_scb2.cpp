#include <cmath>

#include "core/explain/overlap_steps.h"
#include "core/overlap/overlap_scb2.h"

namespace scb {
namespace {

/// The slab of one volume, which the other volume is measured against. All in the frame of A.
struct MeasuredSlab {
    Stage stage;
    bool of_a;
    const Slab& slab;
    const Scb2& other;
    double d;     ///< signed distance of the other's center, along the normal
    Vec3 normal;  ///< the normal in the frame of the other
    Vec3 n;       ///< the normal in A's frame
    std::string own, other_index, mark;
};

OverlapStep slab_step(const MeasuredSlab& s, const Placement& placed) {
    const bool above = !(s.d < 0);
    const double reach = scb2_reach(s.other, Vec3((above ? -1 : 1) * s.normal), 1.0);
    const double plane = above ? s.slab.e : s.slab.f, off = s.d - plane;
    const std::string name = (above ? "e" : "f") + s.own + s.mark;
    const std::string reach_name =
        "ρ" + s.other_index + "(" + (above ? "−" : "") + "n" + s.own + s.mark + ")";
    OverlapStep step = comparison(
        s.stage, 0, "d" + s.own + s.mark + " − " + name + (above ? " > " : " < −") + reach_name,
        off, above ? reach : -reach, std::abs(s.d) - reach - std::abs(plane) - placed.margin,
        is_beyond_plane(s.slab, s.other, s.d, s.normal, placed));
    step.direction = (above == s.of_a ? 1 : -1) * s.n;
    set_terms(step, {slab_distance(above, "d" + s.own + s.mark, s.d),
                     slab_plane(s.of_a, above, name, plane),
                     {s.of_a ? StepTerm::Of::b : StepTerm::Of::a, "−" + reach_name, -reach}});
    return step;
}

/// A step along a direction of both volumes, of any length, by its name.
OverlapStep shared_step(Stage stage, const std::string& left, const std::string& u,
                        const Vec3& direction, double length, double distance, double reach_a,
                        double reach_b, double margin, bool separates) {
    OverlapStep step = comparison(stage, 0, left + " > ρ0(" + u + ") + ρ1(−" + u + ")",
                                  distance / length, (reach_a + reach_b) / length,
                                  (distance - reach_a - reach_b) / length - margin, separates);
    step.direction = direction / length;
    set_terms(step, {{StepTerm::Of::distance, left, distance / length},
                     {StepTerm::Of::a, "−ρ0(" + u + ")", -reach_a / length},
                     {StepTerm::Of::b, "−ρ1(−" + u + ")", -reach_b / length}});
    return step;
}

}  // namespace

OverlapSteps overlap_steps(const Scb2& a, const Scb2& b, const Placement& placed,
                           const OverlapOptions&) {
    const Vec3 c = transform_point(placed.b_to_a, b.c) - a.c;
    Scb2Frames<double> at(a, b, c, placed);
    for (int i = 0; i < 3; ++i) {
        at.measure_along_a(i);
        at.measure_along_b(i);
    }
    const double squared_distance = squared_norm(c), distance = std::sqrt(squared_distance);
    const double margin = placed.margin;
    const LongAxesProduct<double> product(at);

    OverlapSteps result;
    result.margin = margin;
    result.quantities = {{"‖c1′‖", "distance", "distance of the centers", distance},
                         {"d0", "d0", "of B's center from A's, along n0", at.in_a[0] + 0.0},
                         {"d0″", "d0_second", "the same along n0″", at.in_a[1] + 0.0},
                         {"d1", "d1", "of A's center from B's, along n1", -at.in_b[0] + 0.0},
                         {"d1″", "d1_second", "the same along n1″", -at.in_b[1] + 0.0},
                         {"sλ", "sine", "sine of the angle of the long axes", product.length}};
    result.steps.push_back(ball_step(c, a.r, b.r, margin, a.r + b.r + margin));
    result.steps.back().line = 0;
    const auto add_slab = [&](Stage stage, bool of_a, int i) {
        const std::size_t k = static_cast<std::size_t>(i);
        const std::string mark = i == 0 ? "" : "″";
        if (of_a)
            result.steps.push_back(slab_step({stage, true, a.slabs[k], b, at.in_a[i],
                                              Vec3(at.cosines.row(i)), at.a[k], "0", "1", mark},
                                             placed));
        else
            result.steps.push_back(slab_step({stage, false, b.slabs[k], a, -at.in_b[i],
                                              Vec3(at.cosines.col(i)), at.b[k], "1", "0", mark},
                                             placed));
    };
    add_slab(Stage::slab_a, true, 0);
    add_slab(Stage::second_slab_a, true, 1);
    add_slab(Stage::slab_b, false, 0);
    add_slab(Stage::second_slab_b, false, 1);

    double reach_a = scb2_reach(a, at.in_a, distance),
           reach_b = scb2_reach(b, Vec3(-at.in_b), distance);
    if (distance > 0) {
        result.steps.push_back(
            shared_step(Stage::center_line, "‖c1′‖", "u", c, distance, squared_distance, reach_a,
                        reach_b, margin, squared_distance - margin * distance > reach_a + reach_b));
    } else {
        result.steps.push_back(comparison(Stage::center_line, 0, "‖c1′‖ > ρ0(u) + ρ1(−u)", 0,
                                          a.r + b.r, -(a.r + b.r) - margin, false));
        result.steps.back().skipped = "the centers coincide";
    }

    reach_a = scb2_reach(a, product.in_a, product.length);
    reach_b = scb2_reach(b, product.in_b_reversed, product.length);
    const bool separates = product.distance > reach_a + reach_b + margin;
    const bool vanishes = !(product.length > (separates ? 0 : 1e-9));
    const Vec3 w = product.in_a[0] * at.a[0] + product.in_a[1] * at.a[1];
    // The test adds the margin along the product, which is not a unit vector; along a unit vector
    // this margin is larger.
    result.steps.push_back(shared_step(
        Stage::long_axes, "|c1′·w|", "w", w, vanishes ? 1 : product.length, product.distance,
        reach_a, reach_b, vanishes ? margin : margin / product.length, separates));
    if (vanishes) {
        result.steps.back().direction = Vec3::UnitZ();
        // Both sides are next to nothing.
        result.steps.back().skipped = "the long axes are parallel";
    }
    return result;
}

}  // namespace scb
