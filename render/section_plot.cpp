#include "render/section_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/clip.h"
#include "render/figure_layout.h"
#include "render/line_stroke.h"
#include "render/smooth_line.h"

namespace scb {
namespace {

/// What the plane cuts out of a volume, in plane coordinates from the center of A; y is up.
struct Cut {
    double x = 0, y = 0, r = 0;
    bool has_slab = false;
    double nx = 0, ny = 0, e = 0, f = 0;  ///< the slab: f <= nx dx + ny dy <= e
    Rgba8 color;

    double normal_length() const { return std::sqrt(nx * nx + ny * ny); }
};

/// `before`: how far the plane is in front of the center.
Cut cut_of(const AnyVolume& volume, const Vec3& from_a, const SectionPlane& plane, double before,
           Rgba8 color) {
    Cut cut;
    cut.x = dot(plane.right, from_a);
    cut.y = dot(plane.up, from_a);
    cut.color = color;
    double r = 0;
    if (const Ball* ball = std::get_if<Ball>(&volume)) r = ball->radius;
    if (const Scb* s = std::get_if<Scb>(&volume)) {
        r = s->r;
        cut.has_slab = true;
        cut.nx = dot(plane.right, s->n);
        cut.ny = dot(plane.up, s->n);
        const double towards = before * dot(plane.front, s->n);
        cut.e = s->e - towards;
        cut.f = s->f - towards;
    }
    cut.r = std::abs(before) < r ? std::sqrt((r - before) * (r + before)) : 0;
    return cut;
}

struct Extent {
    double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;

    void add(double x, double y, double r = 0) {
        left = std::min(left, x - r);
        right = std::max(right, x + r);
        bottom = std::min(bottom, y - r);
        top = std::max(top, y + r);
    }
};

/// From plane coordinates to pixels of a rectangle.
struct Scale {
    double x0 = 0, y0 = 0, pixels = 1;  ///< what is in the middle of the rectangle; pixels per unit
    PixelRect rect;

    Scale(const PixelRect& box, const Extent& shown) : rect(box) {
        x0 = (shown.left + shown.right) / 2;
        y0 = (shown.bottom + shown.top) / 2;
        const double width = shown.right - shown.left, height = shown.top - shown.bottom;
        pixels = std::min(width > 0 ? 0.9 * box.width / width : HUGE_VAL,
                          height > 0 ? 0.9 * box.height / height : HUGE_VAL);
        // Two points in one place.
        if (!std::isfinite(pixels)) pixels = 1;
    }
    double px(double x) const { return rect.x + rect.width / 2.0 + pixels * (x - x0); }
    double py(double y) const { return rect.y + rect.height / 2.0 - pixels * (y - y0); }
    ScreenPosition at(double x, double y) const { return {px(x), py(y)}; }
    ScreenCircle circle(const Cut& cut) const { return {at(cut.x, cut.y), pixels * cut.r}; }
    /// The points at most k above the cut's center along its normal (`sign` 1), or below it (-1).
    HalfPlane side(const Cut& cut, double k, double sign) const {
        const ScreenPosition n = {sign * cut.nx, -sign * cut.ny}, c = at(cut.x, cut.y);
        return {n, n.x * c.x + n.y * c.y + k * pixels};
    }
    bool shows_height(double y) const { return py(y) >= rect.y && py(y) <= rect.y + rect.height; }
};

/// Where a cut comes nearest to what is below it (`sign` -1) or above: the corner of its cylinder,
/// or of the slab and the circle; else the circle's pole.
ScreenPosition nearest_point(const Cut& cut, double sign, bool cylinder) {
    ScreenPosition best = {cut.x, cut.y + sign * cut.r};
    if (!cut.has_slab || !(cut.normal_length() > 1 - 1e-9)) return best;
    const double pole = cut.ny * sign * cut.r;
    if (!cylinder && pole <= cut.e && pole >= cut.f) return best;
    best.y = -sign * HUGE_VAL;
    for (const double k : {cut.e, cut.f}) {
        const double half = cylinder ? cut.r : std::sqrt(std::max(0.0, cut.r * cut.r - k * k));
        for (const double side : {-half, half}) {
            const double x = cut.x + k * cut.nx - side * cut.ny,
                         y = cut.y + k * cut.ny + side * cut.nx;
            if (sign * y > sign * best.y) best = {x, y};
        }
    }
    return best;
}

struct Shown {
    Extent extent;
    bool detail = false;
};

/// Both balls; or the surroundings of the smaller one, where it could not be seen beside the other;
/// or of a gap that could not.
Shown shown_extent(const Cut& a, const Cut& b, const SectionPlot& plot, const PixelRect& box,
                   int unit) {
    Shown shown;
    for (const Cut& cut : {a, b}) shown.extent.add(cut.x, cut.y, cut.r);
    const double end_a = plot.step.reach_a, end_b = b.y - plot.step.reach_b,
                 pixels = Scale(box, shown.extent).pixels;
    const Cut& small = a.r < b.r ? a : b;
    if (small.r > 0 && pixels * small.r < unit && std::max(a.r, b.r) > 4 * small.r) {
        Extent near;
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
    Drawing(Overlay& overlay, const Scale& scale, const Theme& theme, int unit)
        : overlay_(overlay), scale_(scale), theme_(theme), width_(std::max(1.5, unit / 11.0)) {}

    void region(const Cut& cut) {
        ScreenPolygon polygon = polygon_of(scale_.rect);
        if (cut.normal_length() > 1e-9) {
            polygon = clipped(polygon, scale_.side(cut, cut.e, 1));
            polygon = clipped(polygon, scale_.side(cut, -cut.f, -1));
        } else if (cut.has_slab && (cut.f > 0 || cut.e < 0)) {
            return;
        }
        polygon = clipped(polygon, scale_.circle(cut), scale_.rect);
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

    void ball(const Cut& cut) {
        line(circle_points(scale_.circle(cut), scale_.rect), cut.color, LineStroke::solid,
             width_ / 2);
    }

    /// The slab's planes, a little beyond the ball.
    void slab(const Cut& cut) {
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
    void cylinder(const Cut& cut) {
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
    const Scale& scale_;
    const Theme& theme_;
    double width_;
    std::vector<std::pair<ScreenPosition, ScreenPosition>> outline_;
};

/// A length along the direction of the step, drawn right of the section with its number.
struct Dimension {
    double from = 0, to = 0;
    Rgba8 color;
    std::string label;  ///< may be empty
    int column = 0;
    bool strong = false;
};

std::string length_text(const std::string& name, double value) {
    return name + " = " + (value < 0 ? "−" : "") + number_text(std::abs(value));
}

std::vector<Dimension> dimensions_of(const SectionPlot& plot, double distance, const Theme& theme) {
    const OverlapStep& step = plot.step;
    const double end_a = step.reach_a, end_b = distance - step.reach_b;
    std::vector<Dimension> all;
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
    std::string name = of_a ? "d0" : of_b ? "d1" : "‖c1′‖";
    // The paper's distances are from the owner of the slab, along its normal.
    const Scb* owner = std::get_if<Scb>(of_b ? &plot.b : &plot.a);
    if (owner != nullptr && (of_a || of_b) && (dot(owner->n, step.direction) > 0) != of_a)
        name = "−" + name;
    all.push_back({0, distance, theme.text, length_text(name, distance), 3, false});
    return all;
}

/// Labels one below the other, each as near to its height as the others let it.
std::vector<int> spread(std::vector<double> heights, int line, int top, int bottom) {
    std::vector<int> ys;
    int free = top;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        ys.push_back(std::max(free, static_cast<int>(std::lround(heights[i])) - line / 2));
        free = ys.back() + line;
    }
    int below = bottom;
    for (std::size_t i = ys.size(); i-- > 0;) {
        ys[i] = std::min(ys[i], below - line);
        below = ys[i];
    }
    return ys;
}

constexpr int columns = 4;

int column_step(int unit) { return unit * 3 / 5; }

void draw_dimensions(Overlay& overlay, const Scale& scale, const PixelRect& box,
                     std::vector<Dimension> all, const Theme& theme, int unit, double line_width) {
    const int top = scale.rect.y, bottom = top + scale.rect.height;
    const auto clamped = [&](double y) {
        return std::clamp(scale.py(y), double(top), double(bottom));
    };
    const int label_x = box.x + columns * column_step(unit) + unit / 2;
    for (const Dimension& d : all) {
        const double x = box.x + (d.column + 0.5) * column_step(unit), from = clamped(d.from),
                     to = clamped(d.to), tick = unit / 5.0,
                     width = d.strong ? 2 * line_width : line_width;
        draw_smooth_line(overlay, std::array{ScreenPosition{x, from}, ScreenPosition{x, to}},
                         d.color, width);
        for (const double y : {d.from, d.to})
            if (scale.shows_height(y))
                draw_smooth_line(overlay,
                                 std::array{ScreenPosition{x - tick, scale.py(y)},
                                            ScreenPosition{x + tick, scale.py(y)}},
                                 d.color, line_width);
    }
    std::erase_if(all, [](const Dimension& d) { return d.label.empty(); });
    const auto height = [&](const Dimension& d) { return (clamped(d.from) + clamped(d.to)) / 2; };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Dimension& p, const Dimension& q) { return height(p) < height(q); });
    const int small = small_size(unit), line = small * 5 / 4;
    std::vector<double> heights;
    for (const Dimension& d : all) heights.push_back(height(d));
    const std::vector<int> ys = spread(heights, line, top, bottom);
    for (std::size_t i = 0; i < all.size(); ++i) {
        overlay.rectangle({label_x, ys[i] + small / 2 - small / 4, small / 2, small / 2},
                          all[i].color);
        const TextStyle style{small, all[i].strong ? FontWeight::bold : FontWeight::regular,
                              theme.text};
        overlay.text(label_x + small * 3 / 4, ys[i], all[i].label, style);
    }
}

int label_width(Overlay& overlay, const std::vector<Dimension>& all, int unit) {
    int widest = 0;
    for (const Dimension& d : all)
        widest = std::max(widest,
                          overlay.measure(d.label, {small_size(unit), FontWeight::bold, {}}).width);
    return widest + columns * column_step(unit) + unit / 2 + small_size(unit);
}

}  // namespace

bool SectionPlot::has_cylinder() const {
    return step.stage == Stage::slab_cylinder || step.stage == Stage::cylinder_slab;
}

bool SectionPlot::measures_b() const {
    return step.stage == Stage::slab_ball || step.stage == Stage::slab_cylinder ||
           step.stage == Stage::slab_a;
}

bool draw_section_plot(Overlay& overlay, const PixelRect& rect, const SectionPlot& plot,
                       const Theme& theme, int unit) {
    const Vec3 to_b = center(plot.b) - center(plot.a);
    const SectionPlane& plane = plot.plane;
    const Cut a = cut_of(plot.a, Vec3::Zero(), plane, plane.before_a, body_a_color),
              b = cut_of(plot.b, to_b, plane, plane.before_b, body_b_color);
    const std::vector<Dimension> dimensions = dimensions_of(plot, b.y, theme);
    const int beside = label_width(overlay, dimensions, unit);
    PixelRect box = rect;
    box.width -= beside + unit / 2;
    if (box.width < 3 * unit || box.height < 3 * unit) return false;

    const Shown shown = shown_extent(a, b, plot, box, unit);
    const Scale scale(box, shown.extent);

    Drawing drawing(overlay, scale, theme, unit);
    for (const Cut& cut : {a, b}) drawing.region(cut);
    for (const Cut& cut : {a, b}) {
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
    for (const Cut& cut : {a, b}) drawing.dot(cut.x, cut.y, cut.color, 3 * drawing.width());
    if (plot.common_point) {
        const double px = dot(plane.right, *plot.common_point),
                     py = dot(plane.up, *plot.common_point);
        drawing.dot(px, py, theme.background, 6 * drawing.width());
        drawing.dot(px, py, theme.text, 4 * drawing.width());
    }
    draw_dimensions(overlay, scale, {static_cast<int>(columns_x), rect.y, beside, rect.height},
                    dimensions, theme, unit, drawing.width());
    return shown.detail;
}

}  // namespace scb
