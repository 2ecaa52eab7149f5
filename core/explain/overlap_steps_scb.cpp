#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"
#include "core/explain/overlap_steps.h"
#include "core/overlap/overlap_extents.h"

namespace scb {
namespace {

/// Numbers that all tests of two slab cut balls use.
struct Numbers {
    const Scb &a, &b;
    const Placement& placed;
    Vec3 c = transform_point(placed.b_to_a, b.c) - a.c;
    Vec3 n = transform_direction(placed.b_to_a, b.n);
    double margin = placed.margin;
    double distance = std::sqrt(squared_norm(c));
    double d0 = dot(a.n, c), d1 = -dot(n, c), cosine = dot(a.n, n);
    double squared_sine = placed.squared_sine_bound - cosine * cosine;
    double sine = std::sqrt(std::max(0.0, squared_sine));
};

/// The volume whose slab the other volume is measured against.
struct Owner {
    bool is_a;
    const Scb &own, &other;
    double d;           ///< signed distance of the other's center, along the owner's normal
    const char *i, *j;  ///< the indices of the owner and of the other

    Owner(const Numbers& x, bool a)
        : is_a(a),
          own(a ? x.a : x.b),
          other(a ? x.b : x.a),
          d(a ? x.d0 : x.d1),
          i(a ? "0" : "1"),
          j(a ? "1" : "0") {}

    StepTerm::Of other_side() const { return is_a ? StepTerm::Of::b : StepTerm::Of::a; }
};

/// A plane of a slab, and its name.
struct Plane {
    double at;
    char name;
};
Plane plane_of(const Scb& s, bool upper) { return {upper ? s.e : s.f, upper ? 'e' : 'f'}; }

/// "d0 − e0 > ", "d1 − f1 < −": the other is beyond the plane.
std::string beyond(const Owner& o, bool above, const std::string& from, char plane) {
    return std::string("d") + o.i + from + " − " + plane + o.i + (above ? " > " : " < −");
}

/// Adds the numbers of pictures. The other volume is `above` the slab, or below it; its extent is
/// from its center towards the slab.
OverlapStep along_normal(OverlapStep step, const Numbers& x, const Owner& o, bool above,
                         const Plane& plane, const std::string& reach_name, double reach) {
    const Vec3 outward = (above ? 1 : -1) * (o.is_a ? x.a.n : x.n);
    step.direction = o.is_a ? outward : Vec3(-outward);
    set_terms(step, {slab_distance(above, std::string("d") + o.i, o.d),
                     slab_plane(o.is_a, above, plane.name + std::string(o.i), plane.at),
                     {o.other_side(), "−" + reach_name, -reach}});
    return step;
}

/// The same for a cylinder: the axis up to its `top`, and the effective radius about it.
OverlapStep along_cylinder(OverlapStep step, const Numbers& x, const Owner& o, bool above,
                           const Plane& plane, const Plane& top, double effective) {
    step = along_normal(std::move(step), x, o, above, plane, std::string("r") + o.j + "·sα",
                        effective);
    std::vector<StepTerm> terms = step.terms;
    terms.insert(terms.begin() + 2,
                 {o.other_side(), (above ? "+" : "−") + std::string(1, top.name) + o.j + "·cα",
                  (above ? 1 : -1) * top.at * x.cosine});
    set_terms(step, std::move(terms));
    step.effective_radius = effective;
    return step;
}

/// Lines 4 and 8, see overlap_slabs: the slab of `o` against the other's ball, with this radius.
OverlapStep slab_step(const Numbers& x, const Owner& o, bool above, double radius,
                      const char* radius_index) {
    const Plane plane = plane_of(o.own, above);
    const double off = o.d - plane.at, gap = above ? off : plane.at - o.d;
    OverlapStep step =
        comparison(o.is_a ? Stage::slab_ball : Stage::ball_slab, o.is_a ? 4 : 8,
                   beyond(o, above, "", plane.name) + "r" + radius_index, off,
                   above ? radius : -radius, gap - radius - x.margin, gap > radius + x.margin);
    return along_normal(std::move(step), x, o, above, plane, std::string("r") + radius_index,
                        radius);
}

void add_slab_steps(OverlapSteps& result, const Numbers& x, bool line_8_as_printed) {
    const double r0 = x.a.r, r1 = x.b.r;
    result.steps.push_back(ball_step(x.c, r0, r1, x.margin, r0 + (r1 + x.margin)));
    const Owner a(x, true), b(x, false);
    result.steps.push_back(slab_step(x, a, true, r1, "1"));
    result.steps.push_back(slab_step(x, a, false, r1, "1"));
    result.steps.push_back(slab_step(x, b, true, r0, "0"));
    OverlapStep last =
        slab_step(x, b, false, line_8_as_printed ? r1 : r0, line_8_as_printed ? "1" : "0");
    if (line_8_as_printed) last.error = "as printed: r1, where it must be r0";
    result.steps.push_back(std::move(last));
}

/// A call of CylInFrontOfSlab (`above`) or CylBehindSlab of Figure 8: the slab's plane, and the
/// plane of the other volume that is the top of its cylinder.
OverlapStep cylinder_step(const Numbers& x, const Owner& o, int line, bool above, Plane plane,
                          Plane top) {
    const double r = o.other.r, effective = r * x.sine;
    const double off = o.d + top.at * x.cosine - plane.at;
    const double gap = (above ? off : -off) - x.margin;
    const std::string from = std::string(" + ") + top.name + o.j + "·cα";
    OverlapStep step = comparison(o.is_a ? Stage::slab_cylinder : Stage::cylinder_slab, line,
                                  beyond(o, above, from, plane.name) + "r" + o.j + "·sα", off,
                                  above ? effective : -effective, gap - effective,
                                  gap > 0 && gap * gap > r * r * x.squared_sine);
    return along_cylinder(std::move(step), x, o, above, plane, top, effective);
}

/// Lines 9 to 23, see overlap_figure8.
void add_cylinder_steps(OverlapSteps& result, const Numbers& x, double threshold,
                        bool lines_20_23_as_printed) {
    const bool skipped = !(x.cosine < -threshold) && !(x.cosine > threshold);
    // If they are skipped, the case is the one that a lower threshold would choose.
    const bool opposed = skipped ? x.cosine < 0 : x.cosine < -threshold;
    const bool above = x.d0 > 0, upper = above == opposed;
    const int line = (opposed ? 12 : 19) + (above ? 0 : 3);
    const Plane of_a = plane_of(x.a, above), of_b = plane_of(x.b, upper);
    result.steps.push_back(cylinder_step(x, Owner(x, true), line, above, of_a, of_b));
    const bool exchanged = lines_20_23_as_printed && !opposed;
    result.steps.push_back(exchanged
                               ? cylinder_step(x, Owner(x, false), line + 1, !upper,
                                               plane_of(x.b, !upper), plane_of(x.a, !above))
                               : cylinder_step(x, Owner(x, false), line + 1, upper, of_b, of_a));
    if (exchanged)
        result.steps.back().error = "as printed: the call of line " +
                                    std::to_string(above ? 23 : 20) + ", which never rejects here";
    if (!skipped) return;
    const std::string why =
        format("|n0·n1| = %g is not above a = %g", std::abs(x.cosine), threshold);
    for (std::size_t i = result.steps.size() - 2; i < result.steps.size(); ++i)
        result.steps[i].skipped = why;
}

/// See overlap_symmetric.
OverlapStep symmetric_step(const Numbers& x, const Owner& o) {
    const auto middle = [](const Scb& s) { return (s.e + s.f) / 2; };
    const auto half = [](const Scb& s) { return (s.e - s.f) / 2; };
    const double r = o.other.r, effective = r * x.sine, tilt = std::abs(x.cosine);
    const double off = o.d + middle(o.other) * x.cosine - middle(o.own);
    const double left = std::abs(off) - half(o.own) - half(o.other) * tilt, gap = left - x.margin;
    const std::string i = o.i, j = o.j;
    OverlapStep step = comparison(
        o.is_a ? Stage::slab_cylinder : Stage::cylinder_slab, 0,
        "|d" + i + " + m" + j + "·cα − m" + i + "| − h" + i + " − h" + j + "·|cα| > r" + j + "·sα",
        left, effective, gap - effective, gap > 0 && gap * gap > r * r * x.squared_sine);
    const bool above = off >= 0;
    // The test uses middle and half thickness; pictures show a plane of the slab.
    return along_cylinder(std::move(step), x, o, above, plane_of(o.own, above),
                          plane_of(o.other, above == (x.cosine < 0)), effective);
}

/// See is_beyond_slab.
OverlapStep extent_step(const Numbers& x, const Owner& o) {
    const Scb &own = o.own, &other = o.other;
    const double axis_point = o.d + (other.f > 0   ? other.f
                                     : other.e < 0 ? other.e
                                                   : 0.0) *
                                        x.cosine;
    const bool between = axis_point >= own.f && axis_point <= own.e;
    const bool above = between ? axis_point >= (own.e + own.f) / 2 : axis_point > own.e;
    const double reach =
        reach_at_cosine(other, above ? -x.cosine : x.cosine, x.placed.squared_sine_bound);
    const Plane plane = plane_of(own, above);
    const double off = o.d - plane.at, gap = above ? off : -off;
    const std::string reach_name = std::string("ρ") + o.j + "(" + (above ? "−n" : "n") + o.i + ")";
    OverlapStep step = comparison(
        o.is_a ? Stage::slab_a : Stage::slab_b, 0, beyond(o, above, "", plane.name) + reach_name,
        off, above ? reach : -reach, gap - reach - x.margin,
        above ? o.d - reach > own.e + x.margin : o.d + reach < own.f - x.margin);
    if (between) {
        step.skipped = o.is_a ? "B's axis meets A's slab" : "A's axis meets B's slab";
        step.separates = false;
    }
    return along_normal(std::move(step), x, o, above, plane, reach_name, reach);
}

/// The last step of overlap_extents.
OverlapStep center_line_step(const Numbers& x) {
    const bool apart = x.distance > x.margin;
    const auto reach = [&](const Scb& s, double d) {
        return apart ? reach_at_cosine(s, d / x.distance, x.placed.squared_sine_bound) : s.r;
    };
    const double reach_a = reach(x.a, x.d0), reach_b = reach(x.b, x.d1);
    OverlapStep step = comparison(Stage::center_line, 0, "‖c1′‖ > ρ0(u) + ρ1(−u)", x.distance,
                                  reach_a + reach_b, x.distance - x.margin - (reach_a + reach_b),
                                  apart && x.distance - x.margin > reach_a + reach_b);
    if (apart) step.direction = x.c / x.distance;
    if (!apart) step.skipped = "the centers coincide";
    set_terms(step, {{StepTerm::Of::distance, "‖c1′‖", x.distance},
                     {StepTerm::Of::a, "−ρ0(u)", -reach_a},
                     {StepTerm::Of::b, "−ρ1(−u)", -reach_b}});
    return step;
}

}  // namespace

OverlapSteps overlap_steps(const Scb& a, const Scb& b, const Placement& placed,
                           const OverlapOptions& options) {
    const Numbers x{a, b, placed};
    OverlapSteps result;
    result.margin = placed.margin;
    result.quantities = {{"‖c1′‖", "distance", "distance of the centers", x.distance},
                         {"d0", "d0", "of B's center from A's, along n0", x.d0 + 0.0},
                         {"d1", "d1", "of A's center from B's, along n1", x.d1 + 0.0},
                         {"cα", "cosine", "n0·n1", x.cosine + 0.0},
                         {"sα", "sine", "√(1 − cα²)", x.sine}};
    if (options.test == OverlapTest::extents) {
        const double r0 = a.r, r1 = b.r;
        result.steps = {ball_step(x.c, r0, r1, x.margin, r0 + r1 + x.margin),
                        extent_step(x, Owner(x, true)), extent_step(x, Owner(x, false)),
                        center_line_step(x)};
        for (OverlapStep& step : result.steps) step.line = 0;
        return result;
    }
    add_slab_steps(result, x, options.test == OverlapTest::printed);
    if (options.test == OverlapTest::symmetric) {
        const auto add_slab = [&](const Scb& s, std::string_view middle, std::string_view half,
                                  std::string_view middle_key, std::string_view half_key) {
            result.quantities.push_back(
                {middle, middle_key, "middle of the slab", (s.e + s.f) / 2 + 0.0});
            result.quantities.push_back(
                {half, half_key, "half the slab's thickness", (s.e - s.f) / 2});
        };
        add_slab(a, "m0", "h0", "middle_a", "half_a");
        add_slab(b, "m1", "h1", "middle_b", "half_b");
        result.steps.push_back(symmetric_step(x, Owner(x, true)));
        result.steps.push_back(symmetric_step(x, Owner(x, false)));
    } else {
        add_cylinder_steps(result, x, options.threshold, options.test != OverlapTest::corrected);
    }
    return result;
}

OverlapSteps overlap_steps(const Ball& a, const Ball& b, const Placement& placed,
                           const OverlapOptions&) {
    const Vec3 c = transform_point(placed.b_to_a, b.center) - a.center;
    OverlapSteps result;
    result.margin = placed.margin;
    result.quantities = {
        {"‖c1′‖", "distance", "distance of the centers", std::sqrt(squared_norm(c))}};
    result.steps = {
        ball_step(c, a.radius, b.radius, placed.margin, a.radius + b.radius + placed.margin)};
    return result;
}

}  // namespace scb
