#include "render/explain_figure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/trigonometry.h"
#include "render/ending_colors.h"
#include "render/figure_layout.h"
#include "render/figures.h"
#include "render/fit_camera.h"
#include "render/section_plot.h"
#include "render/slack_chart.h"

namespace scb {
namespace {

const OverlapStep& shown_step(const ExplainFigure& figure) {
    const OverlapSteps& steps = figure.found->steps;
    return steps.steps[steps.closest()];
}

Rgba8 answer_color(Answer answer, const Theme& theme) {
    switch (answer) {
        case Answer::false_positive:
            return theme.accent;
        case Answer::false_negative:
            return theme.warning;
        case Answer::correct:
            break;
    }
    return theme.text;
}

std::string exact_words(const ContactProof& proof) {
    switch (proof.contact) {
        case Contact::disjoint:
            return "disjoint, " + number_text(proof.margin) + " apart";
        case Contact::overlapping:
            return "overlapping, " + number_text(proof.margin) + " deep";
        case Contact::touching:
            break;
    }
    return "touching";
}

double radius_of(const AnyVolume& volume) {
    return std::visit([](const auto& v) { return diameter(v) / 2; }, volume);
}

/// The disc of the plane between two disjoint volumes, in A's frame, beside the smaller one.
Scb separating_disc(const ExplainFigure& figure) {
    const ContactProof& proof = figure.found->proof;
    const Vec3 a = center(figure.a), b = center(figure.b), d = proof.direction;
    const double radius_a = radius_of(figure.a), radius_b = radius_of(figure.b),
                 height = reach(figure.a, d) + proof.margin / 2;
    const Vec3 beside = radius_a < radius_b ? a : b,
               middle = beside + (height - dot(d, beside)) * d;
    const double radius = 1.2 * std::min(radius_a, radius_b);
    return {middle, radius > 0 ? radius : proof.margin / 4, d, 0, 0};
}

/// What the camera has to hold, in the world.
std::vector<AnyVolume> held(const ExplainFigure& figure) {
    std::vector<AnyVolume> volumes = {placed(figure.a, figure.to_world),
                                      placed(figure.b, figure.to_world)};
    if (figure.found->proof.contact == Contact::disjoint)
        volumes.emplace_back(placed(separating_disc(figure), figure.to_world));
    return volumes;
}

Pane pane_of(const ExplainFigure& figure, const Camera& camera, const PixelRect& view, int unit) {
    constexpr double opacity = 0.45;
    const Theme& theme = *figure.theme;
    const ContactProof& proof = figure.found->proof;
    Pane pane;
    pane.viewport = view;
    pane.camera = camera;
    const std::vector<AnyVolume> volumes = held(figure);
    pane.volumes = {{volumes[0], with_opacity(body_a_color, opacity), 1},
                    {volumes[1], with_opacity(body_b_color, opacity), 2}};
    if (proof.contact == Contact::disjoint) {
        pane.volumes.push_back({volumes[2], with_opacity(theme.faint_text, 0.3), 3});
        const Scb& disc = std::get<Scb>(volumes[2]);
        const Vec3 half_gap = proof.margin / 2 * disc.n;
        pane.segments.push_back({disc.c - half_gap, disc.c + half_gap, theme.accent, 3,
                                 std::max(3.0, unit / 6.0), true});
    } else if (proof.contact == Contact::overlapping) {
        const Vec3 point = transform_point(figure.to_world, Vec3(center(figure.a) + proof.point));
        const double size = unit / 3.5 / pixels_per_unit(camera, point, view.height);
        pane.volumes.push_back({Ball{point, size}, theme.text, 3});
    }
    return pane;
}

SectionPlane plane_of(const ExplainFigure& figure) {
    const ContactProof& proof = figure.found->proof;
    return section_plane(
        figure.a, figure.b, shown_step(figure),
        proof.contact == Contact::overlapping ? std::optional(proof.point) : std::nullopt);
}

/// Squares about what is too small to be seen.
void mark_small(Overlay& overlay, const ExplainFigure& figure, const Camera& camera,
                const PixelRect& view, int unit) {
    const Rgba8 colors[] = {body_a_color, body_b_color};
    std::size_t side = 0;
    for (const AnyVolume* volume : {&figure.a, &figure.b}) {
        const Vec3 at = center(placed(*volume, figure.to_world));
        const double scale = pixels_per_unit(camera, at, view.height),
                     radius = radius_of(*volume) * scale;
        const int thickness = std::max(2, unit / 8);
        if (!(radius > unit / 2.0))
            if (const auto square = marker_of(view, camera, at, unit / scale))
                overlay.frame(*square, colors[side], thickness);
        if (!(radius > 1))
            if (const auto dot = marker_of(view, camera, at, thickness / scale))
                overlay.rectangle(*dot, colors[side]);
        ++side;
    }
}

void draw_caption(Overlay& overlay, const PixelRect& box, const std::string& text, Rgba8 color,
                  const std::string& remark, const Theme& theme, int unit) {
    const TextStyle bold{unit, FontWeight::bold, color};
    const TextStyle faint{small_size(unit), FontWeight::regular, theme.faint_text};
    overlay.rectangle({box.x, box.y, box.width, 1}, theme.border);
    overlay.text(box.x, box.y + unit / 4, fitted_text(overlay, text, bold, box.width), bold);
    overlay.text(box.x, box.y + unit * 3 / 2, fitted_text(overlay, remark, faint, box.width),
                 faint);
}

void draw_section(Overlay& overlay, const ExplainFigure& figure, const ExplainLayout& layout) {
    const Theme& theme = *figure.theme;
    const OverlapStep& step = shown_step(figure);
    const ContactProof& proof = figure.found->proof;
    const bool wrong = figure.found->answer == Answer::false_negative;
    SectionPlot plot;
    plot.a = figure.a;
    plot.b = figure.b;
    plot.step = step;
    plot.plane = plane_of(figure);
    plot.gap_color = wrong ? theme.warning : step.separates ? theme.accent : theme.faint_text;
    if (proof.contact == Contact::overlapping) plot.common_point = proof.point;
    const int caption = layout.caption_height();
    PixelRect box = layout.section;
    box.y += caption;
    box.height -= caption;
    const bool zoomed = draw_section_plot(overlay, box, plot, theme, layout.unit);
    const std::string line = step.line > 0 ? "line " + std::to_string(step.line) + ": " : "",
                      text = (step.separates ? "" : "closest, ") + line + step.formula;
    draw_caption(overlay, layout.section, text, wrong ? theme.warning : theme.text,
                 plot.plane.words + (zoomed ? "; a detail" : ""), theme, layout.unit);
}

struct VerdictLine {
    std::string text;
    Rgba8 color;
    FontWeight weight = FontWeight::regular;
    std::optional<Rgba8> swatch{};
};

std::vector<VerdictLine> verdict_lines(const ExplainFigure& figure) {
    const Theme& theme = *figure.theme;
    const PairExplanation& found = *figure.found;
    const Stage stage = found.steps.stage();
    std::vector<VerdictLine> lines;
    const auto shape = [](const AnyVolume& volume) {
        if (const Scb* s = std::get_if<Scb>(&volume))
            return "r " + number_text(s->r) + ", τ " + number_text(thickness(*s));
        if (const Ball* ball = std::get_if<Ball>(&volume)) return "r " + number_text(ball->radius);
        const Vec3& half = std::get<Obb>(volume).half;
        return "half " + number_text(half[0]) + " × " + number_text(half[1]) + " × " +
               number_text(half[2]);
    };
    const std::string test = figure.kind == VolumeKind::scb
                                 ? std::string(overlap_test_name(figure.options.test))
                                 : "test";
    lines.push_back({test + ":  " + ending_words(stage), theme.text, FontWeight::bold,
                     stage == Stage::overlapping
                         ? std::nullopt
                         : std::optional(ending_color(rejected_at(stage), theme))});
    lines.push_back({"exact:  " + exact_words(found.proof), theme.text, FontWeight::bold});
    std::string answer(answer_name(found.answer));
    if (found.answer == Answer::correct)
        answer = "the test is right";
    else
        answer = found.answer == Answer::false_positive
                     ? "FALSE POSITIVE: passed, but disjoint"
                     : "FALSE NEGATIVE: rejected, but overlapping";
    lines.push_back({answer, answer_color(found.answer, theme), FontWeight::bold});
    if (const OverlapStep& step = shown_step(figure); !step.error.empty())
        lines.push_back({"line " + std::to_string(step.line) + " " + step.error, theme.text});
    lines.push_back(
        {figure.names[0] + ":  " + shape(figure.a), theme.text, FontWeight::regular, body_a_color});
    lines.push_back(
        {figure.names[1] + ":  " + shape(figure.b), theme.text, FontWeight::regular, body_b_color});
    // The other tests, those that end alike together.
    std::vector<std::pair<Stage, VerdictLine>> others;
    for (const TestAnswer& t : found.tests) {
        if (t.test == figure.options.test) continue;
        const std::string name(overlap_test_name(t.test));
        const auto same = std::find_if(others.begin(), others.end(),
                                       [&](const auto& o) { return o.first == t.stage; });
        if (same != others.end())
            same->second.text = name + ", " + same->second.text;
        else
            others.push_back(
                {t.stage,
                 {name + ":  " + ending_words(t.stage),
                  t.answer == Answer::correct ? theme.faint_text : answer_color(t.answer, theme)}});
    }
    for (auto& [ending, line] : others) lines.push_back(std::move(line));
    return lines;
}

void draw_verdict(Overlay& overlay, const ExplainFigure& figure, const ExplainLayout& layout) {
    const PixelRect& box = layout.verdict;
    const int small = small_size(layout.unit), line = slack_line(layout.unit),
              indent = small * 5 / 4;
    int y = box.y;
    for (const VerdictLine& v : verdict_lines(figure)) {
        const TextStyle style{small, v.weight, v.color};
        for (const std::string& part : wrapped_text(overlay, v.text, style, box.width - indent)) {
            if (y + line > box.y + box.height) return;
            overlay.text(box.x + indent, y, part, style);
            if (v.swatch && part == wrapped_text(overlay, v.text, style, box.width - indent)[0])
                overlay.rectangle({box.x, y + small / 8, small * 4 / 5, small * 4 / 5}, *v.swatch);
            y += line;
        }
    }
}

}  // namespace

PixelRect ExplainLayout::view_box() const {
    const int caption = caption_height(), below = 2 * unit;
    return {view.x, view.y + caption, view.width, std::max(1, view.height - caption - below)};
}

ExplainLayout explain_layout(int width, int height, const ExplainFigure& figure) {
    const FigureLayout whole = figure_layout(width, height);
    ExplainLayout layout;
    const int unit = layout.unit = whole.unit, margin = whole.heading.x, gap = unit;
    layout.heading = whole.heading;
    const int top = whole.heading.y + whole.heading.height;
    const PixelRect all = {margin, top, width - 2 * margin, height - margin - top};
    const int line = slack_line(unit), chart = slack_chart_lines(figure.found->steps) * line,
              verdict = (static_cast<int>(verdict_lines(figure).size()) + 1) * line;
    const int below = std::min(std::max(chart, verdict), all.height * 9 / 20);
    // Boxes have no section, and small pictures no room for one.
    const bool section = !std::holds_alternative<Obb>(figure.a) &&
                         (whole.portrait || all.height - std::max(chart, verdict) > 12 * unit);
    if (whole.portrait) {
        const int verdict_height = std::min(verdict, all.height / 5),
                  chart_height = std::min(chart, all.height / 3),
                  views = all.height - verdict_height - chart_height - 2 * gap;
        layout.view = {all.x, all.y, all.width, section ? (views - gap / 2) / 2 : views};
        if (section)
            layout.section = {all.x, all.y + views - layout.view.height, all.width,
                              layout.view.height};
        layout.steps = {all.x, all.y + views + gap, all.width, chart_height};
        layout.verdict = {all.x, all.y + all.height - verdict_height, all.width, verdict_height};
    } else if (!section) {
        const int column = std::min(all.width / 2, 26 * unit);
        layout.view = {all.x, all.y, all.width - column - gap, all.height};
        const int x = all.x + all.width - column,
                  chart_height = std::min(chart, all.height * 7 / 10);
        layout.steps = {x, all.y, column, chart_height};
        const int y = all.y + chart_height + gap;
        layout.verdict = {x, y, column, all.y + all.height - y};
    } else {
        const int views = all.height - below - gap / 2, half = (all.width - gap) / 2;
        layout.view = {all.x, all.y, half, views};
        layout.section = {all.x + all.width - half, all.y, half, views};
        const int right = std::min(all.width * 2 / 5, 20 * unit), y = all.y + all.height - below;
        layout.steps = {all.x, y, all.width - right - 3 * gap / 2, below};
        layout.verdict = {all.x + all.width - right, y, right, below};
    }
    return layout;
}

Camera explain_camera(const ExplainFigure& figure, double aspect) {
    const SectionPlane plane = plane_of(figure);
    const SinCos azimuth = sin_cos_degrees(28), elevation = sin_cos_degrees(14);
    const Vec3 level = azimuth.cos * plane.front + azimuth.sin * plane.right,
               back = elevation.cos * level + elevation.sin * plane.up;
    Vec3 right = cross(plane.up, back);
    right /= std::sqrt(squared_norm(right));
    Mat3 axes;
    axes.col(0) = transform_direction(figure.to_world, right);
    axes.col(1) = transform_direction(figure.to_world, cross(back, right));
    axes.col(2) = transform_direction(figure.to_world, back);
    const std::vector<AnyVolume> volumes = held(figure);
    CameraFit fit;
    fit.aspect = aspect;
    fit.margin = 0.06;
    fit.orthographic = figure.orthographic;
    return fit_camera(axes, support_of(volumes), fit);
}

Picture compose(const ExplainFigure& figure, int width, int height, int samples, Overlay& overlay) {
    const ExplainLayout layout = explain_layout(width, height, figure);
    const Theme& theme = *figure.theme;
    const PixelRect view = layout.view_box();
    const Camera camera = figure.camera.value_or(explain_camera(figure, aspect_of(view)));
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    FigureLayout heading;
    heading.unit = layout.unit;
    heading.heading = layout.heading;
    draw_heading(overlay, heading, theme, figure.title, figure.subtitle);
    const ContactProof& proof = figure.found->proof;
    draw_caption(overlay, layout.view, "exact: " + exact_words(proof), theme.text,
                 proof.contact == Contact::disjoint
                     ? "the disc is between the two; across it, the gap"
                 : proof.contact == Contact::overlapping ? "the dot is a point of both"
                                                         : "neither apart nor in each other",
                 theme, layout.unit);
    // Below the view, where the subject never is.
    draw_scale_bar(overlay, layout.view.x + layout.unit / 2, layout.view.y + layout.view.height,
                   view.width / 4,
                   pixels_per_unit(camera, center(placed(figure.a, figure.to_world)), view.height),
                   {theme, layout.unit});
    mark_small(overlay, figure, camera, view, layout.unit);
    if (layout.section.width > 0) draw_section(overlay, figure, layout);
    draw_slack_chart(
        overlay, layout.steps,
        {&figure.found->steps,
         figure.found->answer == Answer::false_negative ? theme.warning : theme.accent},
        theme, layout.unit);
    draw_verdict(overlay, figure, layout);
    picture.panes.push_back(pane_of(figure, camera, view, layout.unit));
    return picture;
}

}  // namespace scb
