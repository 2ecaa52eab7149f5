#include "render/plots/section_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/overlay/figure_layout.h"
#include "render/overlay/line_stroke.h"
#include "render/plots/section_dimensions.h"

namespace scb::render {
namespace {

/// The part that is too small to see in the whole drawing at this scale: the surroundings of the
/// smaller volume, or of the gap between them.
std::optional<SectionExtent> detail_extent(const SectionCut& a, const SectionCut& b,
                                           const SectionPlot& plot, const SectionScale& scale,
                                           int unit) {
    const double end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b, pixels = scale.pixels;
    const SectionCut& small = a.r < b.r ? a : b;
    SectionExtent near;
    if (small.r > 0 && pixels * small.r < unit && std::max(a.r, b.r) > 4 * small.r) {
        near.add(small.x, small.y, 3 * small.r);
        for (const double y : {end_a, end_b})
            near.add(small.x, std::clamp(y, small.y - 8 * small.r, small.y + 8 * small.r));
        return near;
    }
    const double gap = std::abs(end_b - end_a);
    if (!(gap > 0 && pixels * gap < 0.4 * unit) || plot.common_point) return std::nullopt;
    // An eighth of the height, unless the magnification would be too large to understand.
    constexpr double largest = 60;
    const double height = std::max(8 * gap, scale.rect.height / pixels / largest);
    const bool of_b = plot.measures_b();
    const ScreenPosition at = nearest_point(of_b ? b : a, of_b ? -1 : 1, plot.has_cylinder());
    near.add(at.x, (end_a + end_b) / 2, height / 2);
    return near;
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

    /// The cylinder with the slab's height; its axis is in the plane.
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
    void level(double x, double y, double right, Rgba8 color) {
        if (!scale_.shows_height(y)) return;
        const double from = std::clamp(scale_.px(x), double(scale_.rect.x),
                                       double(scale_.rect.x + scale_.rect.width));
        draw_stroke(overlay_, {{from, scale_.py(y)}, {right, scale_.py(y)}}, color,
                    LineStroke::dotted, width_ * 0.7);
    }

    double width() const { return width_; }

  private:
    void line(const std::vector<ScreenPosition>& points, Rgba8 color, LineStroke stroke,
              double thickness) {
        for (const auto& part : clipped(points, scale_.rect))
            draw_stroke(overlay_, part, color, stroke, thickness);
    }

    /// Consecutive segments are one line, so that their joints are drawn once.
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
    std::vector<SectionDimension> all;
    // From A's center up, and from B's down.
    double reached_a = 0, reached_b = distance;
    for (const StepTerm& term : step.terms) {
        if (term.of == StepTerm::Of::distance) {
            all.push_back({0, distance, theme.text, term.name, term.value, false});
            continue;
        }
        const bool of_a = term.of == StepTerm::Of::a,
                   beyond = of_a ? reached_a != 0 : reached_b != distance;
        double& reached = of_a ? reached_a : reached_b;
        const double from = reached;
        reached += of_a ? -term.value : term.value;
        all.push_back(
            {from, reached, of_a ? body_a_color : body_b_color, term.name, term.value, beyond});
    }
    all.push_back({reached_a, reached_b, plot.gap_color, "slack", step.slack, true});
    return all;
}

/// The two volumes, with the shapes that the step uses for them.
void draw_bodies(Drawing& drawing, const SectionPlot& plot, const SectionCut& a,
                 const SectionCut& b, const Theme& theme) {
    for (const SectionCut& cut : {a, b}) drawing.region(cut);
    for (const SectionCut& cut : {a, b}) {
        drawing.ball(cut);
        drawing.slab(cut);
    }
    if (plot.has_cylinder()) drawing.cylinder(plot.measures_b() ? b : a);
    for (const SectionCut& cut : {a, b}) drawing.dot(cut.x, cut.y, cut.color, 3 * drawing.width());
    if (!plot.common_point) return;
    const double x = dot(plot.plane.right, *plot.common_point),
                 y = dot(plot.plane.up, *plot.common_point);
    drawing.dot(x, y, theme.background, 6 * drawing.width());
    drawing.dot(x, y, theme.text, 4 * drawing.width());
}

/// A part of the drawing, magnified in `rect`, and a frame around this part in the whole.
void draw_detail(Overlay& overlay, const PixelRect& rect, const SectionExtent& extent,
                 const SectionScale& whole, const SectionPlot& plot, const SectionCut& a,
                 const SectionCut& b, const Theme& theme, int unit) {
    const SectionScale scale(rect, extent);
    const auto in_whole = [&](double px, double py) {
        return whole.at(scale.x0 + (px - rect.width / 2.0) / scale.pixels,
                        scale.y0 - (py - rect.height / 2.0) / scale.pixels);
    };
    const ScreenPosition first = in_whole(0, 0), last = in_whole(rect.width, rect.height);
    // A frame must not be too small to find.
    const double least = unit / 2.0, middle_x = (first.x + last.x) / 2,
                 middle_y = (first.y + last.y) / 2,
                 half_width = std::max(least, last.x - first.x) / 2,
                 half_height = std::max(least, last.y - first.y) / 2;
    const PixelRect& all = whole.rect;
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp(x, double(all.x), double(all.x + all.width)));
    };
    const auto row = [&](double y) {
        return static_cast<int>(std::clamp(y, double(all.y), double(all.y + all.height)));
    };
    const int left = column(middle_x - half_width), top = row(middle_y - half_height);
    const PixelRect frame = {left, top, std::max(1, column(middle_x + half_width) - left),
                             std::max(1, row(middle_y + half_height) - top)};
    for (const bool below : {false, true})
        draw_smooth_line(overlay,
                         std::array{ScreenPosition{double(rect.x + rect.width),
                                                   double(rect.y + (below ? rect.height : 0))},
                                    ScreenPosition{double(frame.x),
                                                   double(frame.y + (below ? frame.height : 0))}},
                         theme.border, 1);
    overlay.frame(frame, theme.text, std::max(1, unit / 14));

    Drawing drawing(overlay, scale, theme, unit);
    draw_bodies(drawing, plot, a, b, theme);
    const double end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b,
                 x = rect.x + rect.width - unit;
    drawing.level(-HUGE_VAL, end_a, x, body_a_color);
    drawing.level(-HUGE_VAL, end_b, x, body_b_color);
    const auto height_of = [&](double y) {
        return std::clamp(scale.py(y), double(rect.y), double(rect.y + rect.height));
    };
    draw_smooth_line(
        overlay,
        std::array{ScreenPosition{x, height_of(end_a)}, ScreenPosition{x, height_of(end_b)}},
        plot.gap_color, 2 * drawing.width());
    overlay.frame(rect, theme.text, std::max(1, unit / 14));
    draw_scale_bar(overlay, rect.x, rect.y + rect.height + 2 * unit, rect.width * 3 / 4,
                   scale.pixels, {theme, unit});
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
    // Lines and dots extend beyond their exact positions.
    const int edge = unit / 4, numbers = dimensions_width(overlay, dimensions, unit),
              beside = rect.width - numbers < 5 * unit ? 0 : numbers;
    PixelRect box = {rect.x + edge, rect.y + edge, rect.width - edge - beside - unit / 2,
                     rect.height - 2 * edge};
    if (box.width < 3 * unit || box.height < 3 * unit) return false;

    SectionExtent extent;
    for (const SectionCut& cut : {a, b}) extent.add(cut.x, cut.y, cut.r);
    std::optional<SectionExtent> detail;
    PixelRect inset = box;
    if (box.width >= 14 * unit && box.height >= 10 * unit) {
        PixelRect rest = box;
        inset.width = box.width * 2 / 5;
        inset.height = std::min(box.height - 3 * unit, inset.width * 3 / 2);
        inset.y += (box.height - 2 * unit - inset.height) / 2;
        rest.x += inset.width + unit;
        rest.width -= inset.width + unit;
        detail = detail_extent(a, b, plot, SectionScale(rest, extent), unit);
        // If the inset magnifies only a little, a larger whole shows more.
        if (detail && SectionScale(inset, *detail).pixels < 3 * SectionScale(box, extent).pixels)
            detail.reset();
        if (detail) box = rest;
    }
    const SectionScale scale(box, extent);
    Drawing drawing(overlay, scale, theme, unit);
    draw_bodies(drawing, plot, a, b, theme);
    if (detail) draw_detail(overlay, inset, *detail, scale, plot, a, b, theme, unit);

    if (beside == 0) return detail.has_value();
    const double columns_x = rect.x + rect.width - beside, x = std::min(a.x, b.x),
                 end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b;
    drawing.level(x, end_a, columns_x, body_a_color);
    drawing.level(x, end_b, columns_x, body_b_color);
    drawing.level(a.x, 0, columns_x, theme.faint_text);
    drawing.level(b.x, b.y, columns_x, theme.faint_text);
    draw_dimensions(overlay, scale, {static_cast<int>(columns_x), rect.y, beside, rect.height},
                    dimensions, theme, unit, drawing.width());
    return detail.has_value();
}

}  // namespace scb::render
