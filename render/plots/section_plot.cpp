#include "render/plots/section_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/overlay/figure_layout.h"
#include "render/overlay/line_stroke.h"
#include "render/overlay/smooth_line.h"
#include "render/plots/section_dimensions.h"

namespace scb::render {
namespace {

struct Shown {
    SectionExtent extent;
    bool detail = false;
};

/// Both balls; or the surroundings of the smaller one, where it could not be seen beside the other;
/// or of a gap that could not.
Shown shown_extent(const SectionCut& a, const SectionCut& b, const SectionPlot& plot,
                   const PixelRect& box, int unit) {
    Shown shown;
    for (const SectionCut& cut : {a, b}) shown.extent.add(cut.x, cut.y, cut.r);
    const double end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b,
                 pixels = SectionScale(box, shown.extent).pixels;
    const SectionCut& small = a.r < b.r ? a : b;
    if (small.r > 0 && pixels * small.r < unit && std::max(a.r, b.r) > 4 * small.r) {
        SectionExtent near;
        near.add(small.x, small.y, 3 * small.r);
        for (const double y : {end_a, end_b})
            near.add(small.x, std::clamp(y, small.y - 8 * small.r, small.y + 8 * small.r));
        shown = {near, true};
    } else if (const double gap = std::abs(end_b - end_a);
               gap > 0 && pixels * gap < 0.4 * unit && !plot.common_point) {
        // An eighth of the height, if that is not too much of a magnification to be understood.
        constexpr double largest = 60;
        const double height = std::max(8 * gap, box.height / pixels / largest);
        const bool of_b = plot.measures_b();
        const ScreenPosition at = nearest_point(of_b ? b : a, of_b ? -1 : 1, plot.has_cylinder());
        shown = {{}, true};
        shown.extent.add(at.x, (end_a + end_b) / 2, height / 2);
    }
    return shown;
}

class Drawing {
  public:
    Drawing(Overlay& overlay, const SectionScale& scale, const Theme& theme, int unit)
        : overlay_(overlay), scale_(scale), theme_(theme), width_(std::max(1.5, unit / 11.0)) {}

    void region(const SectionCut& cut) {
        ScreenPolygon polygon = polygon_of(scale_.rect);
        for (std::size_t i = 0; i < cut.reaches.size(); ++i)
            polygon = clipped(polygon, scale_.side(cut, i));
        if (cut.normal_length() > 1e-9) {
            polygon = clipped(polygon, scale_.side(cut, cut.e, 1));
            polygon = clipped(polygon, scale_.side(cut, -cut.f, -1));
        } else if (cut.has_slab && (cut.f > 0 || cut.e < 0)) {
            return;
        }
        if (!cut.is_silhouette()) polygon = clipped(polygon, scale_.circle(cut), scale_.rect);
        if (polygon.size() < 2) return;
        if (polygon.size() > 2) overlay_.polygon(polygon, with_opacity(cut.color, 0.35));
        // Not along the border of the drawing.
        polygon.push_back(polygon.front());
        const PixelRect& r = scale_.rect;
        for (std::size_t i = 1; i < polygon.size(); ++i) {
            const ScreenPosition &p = polygon[i - 1], &q = polygon[i];
            const bool on_border = (p.x == q.x && (p.x == r.x || p.x == r.x + r.width)) ||
                                   (p.y == q.y && (p.y == r.y || p.y == r.y + r.height));
            if (!on_border) outline_.push_back({p, q});
        }
        flush_outline(cut.color);
    }

    void ball(const SectionCut& cut) {
        if (cut.is_silhouette()) return;
        line(circle_points(scale_.circle(cut), scale_.rect), cut.color, LineStroke::solid,
             width_ / 2);
    }

    /// The slab's planes, a little beyond the ball.
    void slab(const SectionCut& cut) {
        const double length = cut.normal_length();
        if (!(length > 1e-9)) return;
        for (const double k : {cut.e, cut.f}) {
            const double along = 1.15 * cut.r, nx = cut.nx / length, ny = cut.ny / length,
                         x = cut.x + k / length * nx, y = cut.y + k / length * ny;
            line({scale_.at(x - along * ny, y + along * nx),
                  scale_.at(x + along * ny, y - along * nx)},
                 cut.color, LineStroke::long_dashed, width_ * 0.7);
        }
    }

    /// The cylinder with the slab's height, which the plane holds the axis of.
    void cylinder(const SectionCut& cut) {
        const double nx = cut.nx, ny = cut.ny;
        const auto corner = [&](double k, double side) {
            return scale_.at(cut.x + k * nx - side * cut.r * ny,
                             cut.y + k * ny + side * cut.r * nx);
        };
        line({corner(cut.e, -1), corner(cut.e, 1), corner(cut.f, 1), corner(cut.f, -1),
              corner(cut.e, -1)},
             theme_.text, LineStroke::dashed, width_ * 0.7);
    }

    void dot(double x, double y, Rgba8 color, double size) {
        const ScreenPosition p = scale_.at(x, y);
        const PixelRect& r = scale_.rect;
        if (p.x < r.x || p.y < r.y || p.x > r.x + r.width || p.y > r.y + r.height) return;
        draw_smooth_line(overlay_, std::array{p}, color, size);
    }

    /// A level line from x on to `right`, in pixels.
    void level(double x, double y, double right) {
        if (!scale_.shows_height(y)) return;
        const double from = std::clamp(scale_.px(x), double(scale_.rect.x),
                                       double(scale_.rect.x + scale_.rect.width));
        draw_stroke(overlay_, {{from, scale_.py(y)}, {right, scale_.py(y)}}, theme_.faint_text,
                    LineStroke::dotted, width_ * 0.7);
    }

    double width() const { return width_; }

  private:
    void line(const std::vector<ScreenPosition>& points, Rgba8 color, LineStroke stroke,
              double thickness) {
        for (const auto& part : clipped(points, scale_.rect))
            draw_stroke(overlay_, part, color, stroke, thickness);
    }

    /// Segments that follow each other are one line, so that their joints are drawn once.
    void flush_outline(Rgba8 color) {
        std::vector<ScreenPosition> points;
        for (const auto& [p, q] : outline_) {
            if (!points.empty() && (points.back().x != p.x || points.back().y != p.y)) {
                draw_smooth_line(overlay_, points, color, width_);
                points.clear();
            }
            if (points.empty()) points.push_back(p);
            points.push_back(q);
        }
        if (!points.empty()) draw_smooth_line(overlay_, points, color, width_);
        outline_.clear();
    }

    Overlay& overlay_;
    const SectionScale& scale_;
    const Theme& theme_;
    double width_;
    std::vector<std::pair<ScreenPosition, ScreenPosition>> outline_;
};

std::vector<SectionDimension> dimensions_of(const SectionPlot& plot, double distance,
                                            const Theme& theme) {
    const OverlapStep& step = plot.step;
    const double end_a = step.reach_a, end_b = distance - step.reach_b;
    std::vector<SectionDimension> all;
    // Of a cylinder, its effective radius is the outer part of the reach.
    const auto add_reach = [&](double center, double end, double sign, double reach, Rgba8 color,
                               const std::string& name) {
        if (name != "r_e") {
            all.push_back({center, end, color, length_text(name, reach), 0, false});
            return;
        }
        const double axis = end - sign * step.effective_radius;
        all.push_back({center, axis, color, "", 0, false});
        all.push_back({axis, end, color, length_text(name, step.effective_radius), 1, true});
    };
    add_reach(0, end_a, 1, step.reach_a, body_a_color, step.name_a);
    add_reach(distance, end_b, -1, step.reach_b, body_b_color, step.name_b);
    all.push_back(
        {end_a, end_b, plot.gap_color,
         step.slack > 0 ? length_text("gap", step.slack) : length_text("slack", step.slack), 2,
         true});
    const bool of_a = plot.measures_b(), of_b = step.stage == Stage::ball_slab ||
                                                step.stage == Stage::cylinder_slab ||
                                                step.stage == Stage::slab_b;
    // Of others as the formula has it, on its left: the distance along the direction.
    const bool of_centers =
        step.stage == Stage::ball_ball || step.formula.find(" > ") == std::string::npos;
    std::string name = of_a         ? "d0"
                       : of_b       ? "d1"
                       : of_centers ? "‖c1′‖"
                                    : step.formula.substr(0, step.formula.find(" > "));
    // The paper's distances are from the owner of the slab, along its normal.
    const Scb* owner = std::get_if<Scb>(of_b ? &plot.b : &plot.a);
    if (owner != nullptr && (of_a || of_b) && (dot(owner->n, step.direction) > 0) != of_a)
        name = "−" + name;
    all.push_back({0, distance, theme.text, length_text(name, distance), 3, false});
    return all;
}

}  // namespace

bool SectionPlot::has_cylinder() const {
    return step.stage == Stage::slab_cylinder || step.stage == Stage::cylinder_slab;
}

bool SectionPlot::measures_b() const {
    return step.stage == Stage::slab_ball || step.stage == Stage::slab_cylinder ||
           step.stage == Stage::slab_a || step.stage == Stage::second_slab_a;
}

bool draw_section_plot(Overlay& overlay, const PixelRect& rect, const SectionPlot& plot,
                       const Theme& theme, int unit) {
    const Vec3 to_b = center(plot.b) - center(plot.a);
    const SectionPlane& plane = plot.plane;
    const SectionCut a = section_cut(plot.a, Vec3::Zero(), plane, plane.before_a, body_a_color),
                     b = section_cut(plot.b, to_b, plane, plane.before_b, body_b_color);
    const std::vector<SectionDimension> dimensions = dimensions_of(plot, b.y, theme);
    const int beside = dimensions_width(overlay, dimensions, unit);
    // Lines and dots are wider than what they stand for.
    const int edge = unit / 4;
    PixelRect box = {rect.x + edge, rect.y + edge, rect.width - edge - beside - unit / 2,
                     rect.height - 2 * edge};
    if (box.width < 3 * unit || box.height < 3 * unit) return false;

    const Shown shown = shown_extent(a, b, plot, box, unit);
    const SectionScale scale(box, shown.extent);

    Drawing drawing(overlay, scale, theme, unit);
    for (const SectionCut& cut : {a, b}) drawing.region(cut);
    for (const SectionCut& cut : {a, b}) {
        drawing.ball(cut);
        drawing.slab(cut);
    }
    if (plot.has_cylinder()) drawing.cylinder(plot.measures_b() ? b : a);

    const double columns_x = rect.x + rect.width - beside;
    const double x = shown.detail ? shown.extent.left : std::min(a.x, b.x),
                 end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b;
    for (const double y : {end_a, end_b}) drawing.level(x, y, columns_x);
    drawing.level(a.x, 0, columns_x);
    drawing.level(b.x, b.y, columns_x);
    for (const SectionCut& cut : {a, b}) drawing.dot(cut.x, cut.y, cut.color, 3 * drawing.width());
    if (plot.common_point) {
        const double px = dot(plane.right, *plot.common_point),
                     py = dot(plane.up, *plot.common_point);
        drawing.dot(px, py, theme.background, 6 * drawing.width());
        drawing.dot(px, py, theme.text, 4 * drawing.width());
    }
    // Of the whole, the scale is that of the view beside it.
    if (shown.detail && box.width > 10 * unit && box.height > 6 * unit)
        draw_scale_bar(overlay, box.x + unit / 2, box.y + box.height, box.width / 4, scale.pixels,
                       {theme, unit});
    draw_dimensions(overlay, scale, {static_cast<int>(columns_x), rect.y, beside, rect.height},
                    dimensions, theme, unit, drawing.width());
    return shown.detail;
}

}  // namespace scb::render
