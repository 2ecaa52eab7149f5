#include "render/overlay/line_stroke.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "render/overlay/overlay_shape.h"

namespace scb::render {
namespace {

// Lengths of dashes and gaps in turn, in units of the thickness. Round ends make dashes one longer
// and gaps one shorter.
std::vector<double> pattern_of(LineStroke stroke) {
    switch (stroke) {
        case LineStroke::solid:
            break;
        case LineStroke::long_dashed:
            return {6, 2.5};
        case LineStroke::dashed:
            return {2.5, 2.5};
        case LineStroke::dash_dotted:
            return {4, 2.5, 0, 2.5};
        case LineStroke::dotted:
            return {0, 2.5};
    }
    return {};
}

double sample_thickness(const FigureStyle& style) { return 1.5 * stroke_width(style); }

}  // namespace

LineStroke stroke_of_line(std::size_t i) {
    constexpr std::array<LineStroke, line_stroke_count> order = {
        LineStroke::solid, LineStroke::dashed, LineStroke::dotted, LineStroke::dash_dotted,
        LineStroke::long_dashed};
    return order[i % order.size()];
}

int stroke_width(const FigureStyle& style) { return std::max(2, style.unit / 8); }

void draw_stroke(Overlay& overlay, const std::vector<ScreenPosition>& points, Rgba8 color,
                 LineStroke stroke, double thickness) {
    if (points.size() == 1) return draw_smooth_line(overlay, points, color, 3 * thickness);
    std::vector<double> pattern = pattern_of(stroke);
    if (pattern.empty()) return draw_smooth_line(overlay, points, color, thickness);
    for (double& length : pattern) length *= thickness;
    for (const auto& dash : dashes(points, pattern))
        draw_smooth_line(overlay, dash, color, thickness);
}

void draw_line_sample(Overlay& overlay, int x, int y, int width, Rgba8 color, LineStroke stroke,
                      const FigureStyle& style) {
    const double thickness = sample_thickness(style), inset = thickness / 2;
    draw_stroke(overlay, {{x + inset, y + 0.5}, {x + width - inset, y + 0.5}}, color, stroke,
                thickness);
}

int line_sample_width(const FigureStyle& style) {
    // Two of the longest dashes with the gap between them.
    return static_cast<int>(15 * sample_thickness(style));
}

namespace {

// Positions are whole sixteenths of a pixel; a pixel is sampled at 8 x 8 odd positions.
constexpr std::int64_t pixel_units = 16;
constexpr int samples = 8;
constexpr std::uint64_t all_samples = ~std::uint64_t{0};

// No picture has pixels further out, and squares of lengths must fit.
constexpr double farthest = 65536;

// The number of columns of pixels that are covered at a time; it bounds the memory for any size of
// picture.
constexpr int strip_width = 64;

struct Point {
    std::int64_t x = 0, y = 0;
};

Point snapped(const ScreenPosition& p) {
    const auto unit = [](double v) {
        return static_cast<std::int64_t>(
            std::llround(std::clamp(v, -farthest, farthest) * pixel_units));
    };
    return {unit(p.x), unit(p.y)};
}

struct Stroke {
    Point from, to;

    // Whether a sample is within the radius.
    bool covers(Point s, std::int64_t radius) const {
        const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
        const std::int64_t sx = s.x - from.x, sy = s.y - from.y;
        const std::int64_t along = sx * dx + sy * dy, square = dx * dx + dy * dy;
        if (along <= 0) return sx * sx + sy * sy <= radius * radius;
        if (along >= square) {
            const std::int64_t ex = s.x - to.x, ey = s.y - to.y;
            return ex * ex + ey * ey <= radius * radius;
        }
        const std::int64_t across = std::abs(sx * dy - sy * dx);
        // The square may not fit, but then the distance is larger than any radius.
        return across < (std::int64_t{1} << 31) && across * across <= radius * radius * square;
    }
};

int pixel_below(double units) { return static_cast<int>(std::floor(units / pixel_units)); }

/// The samples that a line covers in some columns of pixels.
struct Strip {
    int x, y, width, height;
    std::vector<std::uint64_t> masks;  // column by column

    std::uint64_t& mask(int px, int py) {
        return masks[static_cast<std::size_t>(px - x) * static_cast<std::size_t>(height) +
                     static_cast<std::size_t>(py - y)];
    }

    void add(const Stroke& segment, std::int64_t radius) {
        const Point& a = segment.from;
        const Point& b = segment.to;
        const int first =
            std::max(x, pixel_below(static_cast<double>(std::min(a.x, b.x) - radius)));
        const int last =
            std::min(x + width - 1, pixel_below(static_cast<double>(std::max(a.x, b.x) + radius)));
        for (int px = first; px <= last; ++px) {
            // Only the part of the segment within the radius of this column can reach it.
            std::int64_t low = std::min(a.y, b.y), high = std::max(a.y, b.y);
            if (a.x != b.x) {
                const auto y_at = [&](std::int64_t at) {
                    const std::int64_t inside =
                        std::clamp(at, std::min(a.x, b.x), std::max(a.x, b.x));
                    return a.y + (b.y - a.y) * (inside - a.x) / (b.x - a.x);
                };
                const std::int64_t y0 = y_at(px * pixel_units - radius),
                                   y1 = y_at((px + 1) * pixel_units + radius);
                low = std::max(low, std::min(y0, y1) - 1);
                high = std::min(high, std::max(y0, y1) + 1);
            }
            const int top = std::max(y, pixel_below(static_cast<double>(low - radius)));
            const int bottom =
                std::min(y + height - 1, pixel_below(static_cast<double>(high + radius)));
            for (int py = top; py <= bottom; ++py) cover(segment, radius, px, py);
        }
    }

    void cover(const Stroke& segment, std::int64_t radius, int px, int py) {
        std::uint64_t& covered = mask(px, py);
        if (covered == all_samples) return;
        // No sample is farther than ten units from the middle.
        const Point middle{px * pixel_units + pixel_units / 2, py * pixel_units + pixel_units / 2};
        if (!segment.covers(middle, radius + 10)) return;
        if (radius > 10 && segment.covers(middle, radius - 10)) {
            covered = all_samples;
            return;
        }
        for (int i = 0; i < samples * samples; ++i) {
            const Point sample{px * pixel_units + 2 * (i % samples) + 1,
                               py * pixel_units + 2 * (i / samples) + 1};
            if (segment.covers(sample, radius)) covered |= std::uint64_t{1} << i;
        }
    }

    void draw(Overlay& overlay, Rgba8 color) {
        for (int px = x; px < x + width; ++px)
            for (int py = y; py < y + height;) {
                const int count = std::popcount(mask(px, py));
                int end = py + 1;
                while (end < y + height && std::popcount(mask(px, end)) == count) ++end;
                Rgba8 share = color;
                share.a = static_cast<std::uint8_t>((color.a * count + 32) / 64);
                if (share.a > 0) overlay.rectangle({px, py, 1, end - py}, share);
                py = end;
            }
    }
};

}  // namespace

void draw_smooth_line(Overlay& overlay, std::span<const ScreenPosition> points, Rgba8 color,
                      double thickness) {
    if (points.empty()) return;
    // Recorded as a line, not as its pixels.
    OverlayShapes* const noted = overlay.note_in(nullptr);
    if (noted != nullptr)
        noted->list.emplace_back(LineShape{{points.begin(), points.end()}, color, thickness, true});
    const std::int64_t radius =
        std::max<std::int64_t>(1, std::llround(std::min(thickness, 1000.0) * pixel_units / 2));
    std::vector<Stroke> segments;
    Point last = snapped(points[0]), low = last, high = last;
    if (points.size() == 1) segments.push_back({last, last});
    for (const ScreenPosition& p : points.subspan(1)) {
        const Point next = snapped(p);
        segments.push_back({last, next});
        last = next;
        low = {std::min(low.x, next.x), std::min(low.y, next.y)};
        high = {std::max(high.x, next.x), std::max(high.y, next.y)};
    }
    const int left = pixel_below(static_cast<double>(low.x - radius)),
              top = pixel_below(static_cast<double>(low.y - radius)),
              right = pixel_below(static_cast<double>(high.x + radius)) + 1,
              bottom = pixel_below(static_cast<double>(high.y + radius)) + 1;
    for (int x = left; x < right; x += strip_width) {
        const int width = std::min(strip_width, right - x), height = bottom - top;
        Strip strip{x, top, width, height, {}};
        strip.masks.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (const Stroke& segment : segments) strip.add(segment, radius);
        strip.draw(overlay, color);
    }
    overlay.note_in(noted);
}

std::vector<std::vector<ScreenPosition>> dashes(std::span<const ScreenPosition> points,
                                                std::span<const double> pattern) {
    std::vector<std::vector<ScreenPosition>> result;
    if (points.empty() || pattern.empty()) return result;
    std::size_t turn = 0;
    bool drawing = true;
    double left = std::max(pattern[0], 1.0);
    result.push_back({points[0]});
    for (std::size_t i = 1; i < points.size(); ++i) {
        ScreenPosition from = points[i - 1];
        const ScreenPosition to = points[i];
        for (;;) {
            const double dx = to.x - from.x, dy = to.y - from.y;
            const double length = std::sqrt(dx * dx + dy * dy);
            if (length <= left) {
                left -= length;
                if (drawing) result.back().push_back(to);
                break;
            }
            const double t = left / length;
            from = {from.x + t * dx, from.y + t * dy};
            if (drawing)
                result.back().push_back(from);
            else
                result.push_back({from});
            drawing = !drawing;
            turn = (turn + 1) % pattern.size();
            left = std::max(pattern[turn], 1.0);
        }
    }
    return result;
}

}  // namespace scb::render
