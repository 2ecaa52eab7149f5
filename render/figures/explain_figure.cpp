#include "render/figures/explain_figure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/portable_math.h"
#include "render/figures/explain_verdict.h"
#include "render/overlay/clip.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/line_stroke.h"
#include "render/overlay/scales.h"
#include "render/plots/section_cut.h"
#include "render/plots/section_plot.h"
#include "render/plots/slack_chart.h"
#include "render/view/fit_camera.h"

namespace scb::render {
namespace {

double radius_of(const AnyVolume& volume) {
    return std::visit([](const auto& v) { return diameter(v) / 2; }, volume);
}

/// The disc of the plane between two disjoint volumes, in A's frame, beside the smaller one.
Scb separating_disc(const ExplainFigure& figure) {
    const ContactCertificate& certificate = figure.found->certificate;
    const Vec3 a = center(figure.a), b = center(figure.b), d = certificate.direction;
    const double radius_a = radius_of(figure.a), radius_b = radius_of(figure.b),
                 height = reach(figure.a, d) + certificate.margin / 2;
    const Vec3 beside = radius_a < radius_b ? a : b,
               middle = beside + (height - dot(d, beside)) * d;
    const double radius = 1.2 * std::min(radius_a, radius_b);
    return {middle, radius > 0 ? radius : certificate.margin / 4, d, 0, 0};
}

/// The volumes that the camera must show, in the world.
std::vector<AnyVolume> held(const ExplainFigure& figure) {
    std::vector<AnyVolume> volumes = {placed(figure.a, figure.to_world),
                                      placed(figure.b, figure.to_world)};
    if (figure.found->certificate.contact == Contact::disjoint)
        volumes.emplace_back(placed(separating_disc(figure), figure.to_world));
    return volumes;
}

Pane pane_of(const ExplainFigure& figure, const Camera& camera, const PixelRect& view, int unit) {
    const Theme& theme = *figure.theme;
    const ContactCertificate& certificate = figure.found->certificate;
    Pane pane;
    pane.viewport = view;
    pane.camera = camera;
    const std::vector<AnyVolume> volumes = held(figure);
    const double opacity = figure.triangles ? 0.3 : 0.45;
    pane.volumes = {{volumes[0], with_opacity(body_a_color, opacity), 1},
                    {volumes[1], with_opacity(body_b_color, opacity), 2}};
    if (figure.triangles) {
        pane.meshes.assign(figure.triangles->begin(), figure.triangles->end());
        pane.meshes[0].color = body_a_color;
        pane.meshes[1].color = body_b_color;
        for (MeshDraw& mesh : pane.meshes) mesh.edges = true;
    }
    if (certificate.contact == Contact::disjoint) {
        pane.volumes.push_back({volumes[2], with_opacity(theme.faint_text, 0.3), 3});
        const Scb& disc = std::get<Scb>(volumes[2]);
        // explain_camera sees the disc edge-on, so a line shows it.
        if (!figure.camera) {
            const Vec3 across = disc.r * camera.axes.col(0);
            pane.segments.push_back(
                {disc.c - across, disc.c + across, theme.faint_text, 3, unit / 12.0, true});
        }
        const Vec3 half_gap = certificate.margin / 2 * disc.n;
        pane.segments.push_back({disc.c - half_gap, disc.c + half_gap, theme.accent, 3,
                                 std::max(3.0, unit / 6.0), true});
    }
    return pane;
}

SectionPlane plane_of(const ExplainFigure& figure) {
    const ContactCertificate& certificate = figure.found->certificate;
    return section_plane(figure.a, figure.b, shown_step(figure),
                         certificate.contact == Contact::overlapping
                             ? std::optional(certificate.point)
                             : std::nullopt);
}

/// The common point, also if something hides it.
void mark_common_point(Overlay& overlay, const ExplainFigure& figure, const Camera& camera,
                       const PixelRect& view, int unit) {
    const ContactCertificate& certificate = figure.found->certificate;
    if (certificate.contact != Contact::overlapping) return;
    const Vec3 point = transform_point(figure.to_world, Vec3(center(figure.a) + certificate.point)),
               at = project(camera, point, view.width, view.height);
    const ScreenPosition position{view.x + at[0], view.y + at[1]};
    const int reach = unit / 2;
    if (!(position.x >= view.x + reach && position.x <= view.x + view.width - reach &&
          position.y >= view.y + reach && position.y <= view.y + view.height - reach))
        return;
    draw_smooth_line(overlay, std::array{position}, figure.theme->background, unit * 0.8);
    draw_smooth_line(overlay, std::array{position}, figure.theme->text, unit * 0.5);
}

/// The extent of a volume in a view from the view's center, in each silhouette_direction.
std::vector<double> outline_of(const AnyVolume& volume, const Camera& camera,
                               const PixelRect& view) {
    constexpr std::size_t count = 180;
    const double height = camera.orthographic ? camera.view_height : 2 * tan_half_fov(camera);
    std::vector<double> reaches;
    for (std::size_t i = 0; i < count; ++i) {
        const ScreenPosition d = silhouette_direction(i, count);
        const Vec3 across = d.x * camera.axes.col(0) + d.y * camera.axes.col(1);
        const auto beyond = [&](const Vec3& direction) {
            const double length = std::sqrt(squared_norm(direction));
            return length * reach(volume, Vec3(direction / length)) -
                   dot(direction, camera.position);
        };
        double low = -10 * height, high = 10 * height;
        if (camera.orthographic) low = high = beyond(across);
        // The slope of the plane through the eye that touches the volume, by bisection.
        for (int k = 0; k < 40 && low < high; ++k) {
            const double slope = (low + high) / 2;
            (beyond(across + slope * Vec3(camera.axes.col(2))) > 0 ? low : high) = slope;
        }
        reaches.push_back(view.height / height * (low + high) / 2);
    }
    return reaches;
}

/// The outline of a volume that the other one hides or seems to hide, over everything.
void mark_hidden(Overlay& overlay, const ExplainFigure& figure, const Camera& camera,
                 const PixelRect& view, int unit) {
    const std::vector<double> outlines[] = {
        outline_of(placed(figure.a, figure.to_world), camera, view),
        outline_of(placed(figure.b, figure.to_world), camera, view)};
    const Rgba8 colors[] = {body_a_color, body_b_color};
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const std::vector<double>&inner = outlines[side], &outer = outlines[1 - side];
        bool hidden = true;
        for (std::size_t i = 0; i < inner.size(); ++i) hidden &= inner[i] <= outer[i] + 1;
        if (!hidden) continue;
        ScreenPolygon polygon = polygon_of(view);
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const ScreenPosition d = silhouette_direction(i, inner.size()), normal = {d.x, -d.y};
            polygon = clipped(
                polygon, HalfPlane{normal, normal.x * (view.x + view.width / 2.0) +
                                               normal.y * (view.y + view.height / 2.0) + inner[i]});
        }
        if (polygon.size() < 3) continue;
        overlay.polygon(polygon, with_opacity(colors[side], 0.25));
        polygon.push_back(polygon.front());
        draw_stroke(overlay, polygon, colors[side], LineStroke::dashed, std::max(1.5, unit / 10.0));
    }
}

/// Squares about things that are too small to see.
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
    const ContactCertificate& certificate = figure.found->certificate;
    const bool wrong = figure.found->answer == Answer::false_negative;
    SectionPlot plot;
    plot.a = figure.a;
    plot.b = figure.b;
    plot.step = step;
    plot.plane = plane_of(figure);
    plot.gap_color = wrong ? theme.warning : step.separates ? theme.accent : theme.faint_text;
    if (certificate.contact == Contact::overlapping) plot.common_point = certificate.point;
    const int caption = layout.caption_height();
    PixelRect box = layout.section;
    box.y += caption;
    box.height -= caption;
    const bool zoomed = draw_section_plot(overlay, box, plot, theme, layout.unit);
    std::string text = step.separates ? "" : "closest, ";
    if (step.line > 0) text += "line " + std::to_string(step.line) + ": ";
    text += "slack =";
    for (const StepTerm& term : step.terms) {
        // Signs are set apart: they are "+", or "−" with three bytes.
        const std::size_t sign = term.name.starts_with("+")   ? 1
                                 : term.name.starts_with("−") ? 3
                                                              : 0;
        text += " " + term.name.substr(0, sign) + (text.ends_with("=") ? "" : " ") +
                term.name.substr(sign);
    }
    draw_caption(overlay, layout.section, text, wrong ? theme.warning : theme.text,
                 plot.plane.words + (zoomed ? "; left: the frame, magnified" : ""), theme,
                 layout.unit);
}

void draw_footnote(Overlay& overlay, const ExplainFigure& figure, const ExplainLayout& layout) {
    std::string text;
    for (const std::string_view line : symbol_lines(figure.kind, figure.options))
        text += (text.empty() ? "" : " ") + std::string(line);
    const TextStyle faint{small_size(layout.unit), FontWeight::regular, figure.theme->faint_text};
    const PixelRect& box = layout.footnote;
    int y = box.y;
    for (const std::string& line : wrapped_text(overlay, text, faint, box.width)) {
        if (y + faint.size > box.y + box.height) return;
        overlay.text(box.x, y, line, faint);
        y += faint.size * 5 / 4;
    }
}

}  // namespace

Camera explain_camera(const ExplainFigure& figure, double aspect) {
    const SectionPlane plane = plane_of(figure);
    const ContactCertificate& certificate = figure.found->certificate;
    // The camera looks along the plane between the two, so that neither seems to cross it.
    const bool apart = certificate.contact == Contact::disjoint;
    const Vec3 up = apart ? certificate.direction : plane.up;
    Vec3 front = plane.front - dot(up, plane.front) * up;
    if (!(squared_norm(front) > 0.01)) front = plane.right - dot(up, plane.right) * up;
    front /= std::sqrt(squared_norm(front));
    const SinCos azimuth = sin_cos_degrees(28), elevation = sin_cos_degrees(apart ? 0 : 14);
    const Vec3 level = azimuth.cos * front + azimuth.sin * cross(up, front),
               back = elevation.cos * level + elevation.sin * up;
    Vec3 right = cross(up, back);
    right /= std::sqrt(squared_norm(right));
    Mat3 axes;
    axes.col(0) = transform_direction(figure.to_world, right);
    axes.col(1) = transform_direction(figure.to_world, cross(back, right));
    axes.col(2) = transform_direction(figure.to_world, back);
    const std::vector<AnyVolume> volumes = held(figure);
    CameraFit fit;
    fit.aspect = aspect;
    fit.margin = 0.06;
    fit.orthographic = figure.orthographic || apart;
    return fit_camera(axes, support_of(volumes), fit);
}

Picture compose(const ExplainFigure& figure, int width, int height, int samples, Overlay& overlay) {
    const ExplainLayout layout = explain_layout(width, height, figure, overlay);
    const Theme& theme = *figure.theme;
    const PixelRect view = layout.view_box();
    const Camera camera = figure.camera.value_or(explain_camera(figure, aspect_of(view)));
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    FigureLayout heading;
    heading.unit = layout.unit;
    heading.heading = layout.heading;
    draw_heading(overlay, heading, theme, figure.title, figure.subtitle);
    const ContactCertificate& certificate = figure.found->certificate;
    draw_caption(overlay, layout.view, "exact: " + exact_words(certificate), theme.text,
                 certificate.contact == Contact::disjoint
                     ? figure.camera ? "the disc is between the two; across it, the gap"
                                     : "seen along a plane between the two; across it, the gap"
                 : certificate.contact == Contact::overlapping ? "the dot is a point of both"
                                                               : "neither apart nor in each other",
                 theme, layout.unit);
    // Below the view, where it never covers the subject.
    draw_scale_bar(overlay, layout.view.x + layout.unit / 2, layout.view.y + layout.view.height,
                   view.width / 4,
                   pixels_per_unit(camera, center(placed(figure.a, figure.to_world)), view.height),
                   {theme, layout.unit});
    mark_hidden(overlay, figure, camera, view, layout.unit);
    mark_small(overlay, figure, camera, view, layout.unit);
    mark_common_point(overlay, figure, camera, view, layout.unit);
    if (layout.section.width > 0) draw_section(overlay, figure, layout);
    draw_slack_chart(
        overlay, layout.steps,
        {&figure.found->steps,
         figure.found->answer == Answer::false_negative ? theme.warning : theme.accent},
        theme, layout.unit);
    draw_verdict(overlay, layout.verdict, figure, layout.unit);
    draw_footnote(overlay, figure, layout);
    picture.panes.push_back(pane_of(figure, camera, view, layout.unit));
    return picture;
}

}  // namespace scb::render
