#include "render/overlay/line_stroke.h"

#include <algorithm>
#include <array>

#include "render/overlay/smooth_line.h"

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

}  // namespace scb::render
