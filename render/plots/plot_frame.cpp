#include "render/plots/plot_frame.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"

namespace scb::render {
namespace {

int hairline(const FigureStyle& style) { return std::max(1, style.unit / 20); }
int line_height(const FigureStyle& style) { return style.unit * 5 / 4; }
int tick_length(const FigureStyle& style) { return std::max(3, style.unit / 4); }

TextStyle label_style(const FigureStyle& style, Align align = Align::left) {
    return {small_size(style.unit), FontWeight::regular, style.theme.faint_text, align};
}

bool has_labels(const std::vector<PlotRange>& ranges) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [](const PlotRange& range) { return !range.label.empty(); });
}

struct FramePainter {
    Overlay& overlay;
    const PixelRect& rect;
    const PlotFrame& frame;
    const FigureStyle& style;
    PixelRect area{};

    int x_of(double value) const {
        return area.x +
               static_cast<int>(std::lround(axis_position(frame.x, value) * (area.width - 1)));
    }
    int y_of(double value) const {
        return area.y + static_cast<int>(
                            std::lround((1 - axis_position(frame.y, value)) * (area.height - 1)));
    }

    void lay_out() {
        int left = 0;
        for (const AxisTick& tick : frame.y.ticks)
            left = std::max(left, overlay.measure(tick.label, label_style(style)).width);
        left += style.unit / 2;
        int top = 0, bottom = tick_length(style) + small_size(style.unit) + 2;
        if (!frame.title.empty()) top += line_height(style);
        if (!frame.y_label.empty()) top += line_height(style);
        // Half of the uppermost label of the y axis is above the data.
        top += has_labels(frame.ranges) ? line_height(style) : small_size(style.unit) / 2 + 1;
        if (!frame.x_label.empty()) bottom += line_height(style);
        area = {rect.x + left, rect.y + top, std::max(0, rect.width - left - frame.right),
                std::max(0, rect.height - top - bottom)};
        if (area.width < 2 * style.unit || area.height < 2 * style.unit)
            area.width = area.height = 0;
    }

    void draw_headings() {
        int y = rect.y;
        if (!frame.title.empty()) {
            const TextStyle bold{style.unit, FontWeight::bold, style.theme.text};
            overlay.text(rect.x, y, fitted_text(overlay, frame.title, bold, rect.width), bold);
            y += line_height(style);
        }
        if (!frame.y_label.empty())
            overlay.text(rect.x, y,
                         fitted_text(overlay, frame.y_label, label_style(style), rect.width),
                         label_style(style));
    }

    void draw_ranges() {
        const int y = area.y - small_size(style.unit) * 6 / 5 - 1;
        int free_from = rect.x;
        for (const PlotRange& range : frame.ranges) {
            if (!(range.from <= range.to) || range.to < frame.x.low || range.from > frame.x.high)
                continue;
            // Ranges may be infinite.
            const int from = x_of(std::max(range.from, frame.x.low));
            const int width =
                std::max(2 * hairline(style), x_of(std::min(range.to, frame.x.high)) - from + 1);
            overlay.rectangle({from, area.y, width, area.height},
                              mix(style.theme.background, style.theme.border, 0.55));
            // Labels are over the middle of their range, but within the rectangle and apart from
            // each other.
            const TextStyle text = label_style(style);
            const std::string label = fitted_text(overlay, range.label, text, rect.width - 1);
            // Some letters lean out of their box.
            const int room = overlay.measure(label, text).width + 1;
            const int x = std::clamp(from + (width - room) / 2, rect.x,
                                     std::max(rect.x, rect.x + rect.width - room));
            if (label.empty() || x < free_from) continue;
            free_from = x + room + style.unit / 2;
            overlay.text(x, y, label, text);
        }
    }

    void draw_y_axis() {
        const TextStyle text = label_style(style, Align::right);
        const int small = small_size(style.unit);
        for (const AxisTick& tick : frame.y.ticks) {
            const int y = y_of(tick.value);
            overlay.rectangle({area.x, y, area.width, hairline(style)},
                              with_opacity(style.theme.border, tick.label.empty() ? 0.25 : 0.7));
            overlay.text(area.x - style.unit / 2 + style.unit / 10, y - small / 2, tick.label,
                         text);
        }
    }

    void draw_x_axis() {
        const TextStyle text = label_style(style);
        const int below = area.y + area.height;
        overlay.rectangle({area.x, below, area.width, hairline(style)}, style.theme.faint_text);
        int free_from = rect.x;
        for (const AxisTick& tick : frame.x.ticks) {
            const int at = x_of(tick.value), width = overlay.measure(tick.label, text).width;
            overlay.rectangle({at, below, hairline(style), tick_length(style)},
                              style.theme.faint_text);
            const int x =
                std::clamp(at - width / 2, rect.x, std::max(rect.x, rect.x + rect.width - width));
            if (x < free_from) continue;
            free_from = x + width + style.unit / 2;
            overlay.text(x, below + tick_length(style) + 1, tick.label, text);
        }
        if (!frame.x_label.empty())
            overlay.text(area.x + area.width / 2,
                         below + tick_length(style) + 2 + small_size(style.unit) * 6 / 5,
                         fitted_text(overlay, frame.x_label, text, area.width),
                         label_style(style, Align::center));
    }
};

}  // namespace

int most_x_ticks(const PixelRect& rect, const FigureStyle& style) {
    return std::clamp(rect.width / (5 * style.unit), 3, 9);
}

int most_y_ticks(const PixelRect& rect, const FigureStyle& style) {
    return std::clamp((rect.height - 5 * style.unit) / (2 * style.unit), 3, 9);
}

PixelRect plot_area(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                    const FigureStyle& style) {
    FramePainter painter{overlay, rect, frame, style};
    painter.lay_out();
    return painter.area;
}

PixelRect draw_plot_frame(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                          const FigureStyle& style) {
    FramePainter painter{overlay, rect, frame, style};
    painter.lay_out();
    if (painter.area.width == 0) return painter.area;
    painter.draw_headings();
    painter.draw_ranges();
    painter.draw_y_axis();
    painter.draw_x_axis();
    return painter.area;
}

}  // namespace scb::render
