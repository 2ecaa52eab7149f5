#include "render/overlay/scales.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"
#include "render/overlay/font_face.h"

namespace scb::render {

namespace {

TextStyle body(const FigureStyle& style) {
    return {small_size(style.unit), FontWeight::regular, style.theme.text, Align::left};
}

TextStyle heading(const FigureStyle& style) {
    return {small_size(style.unit), FontWeight::medium, style.theme.text, Align::left};
}

TextStyle aligned(TextStyle text, Align align) {
    text.align = align;
    return text;
}

int line_height(const FigureStyle& style) { return small_size(style.unit) * 13 / 10; }

PixelRect together(const PixelRect& a, const PixelRect& b) {
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
            std::max(a.y + a.height, b.y + b.height) - y};
}

/// Writes a text; returns the rectangle that it covers.
PixelRect write(Overlay& overlay, int x, int y, std::string_view text, const TextStyle& style) {
    overlay.text(x, y, text, style);
    const TextSize size = overlay.measure(text, style);
    const int shift = style.align == Align::left
                          ? 0
                          : (style.align == Align::center ? size.width / 2 : size.width);
    return {x - shift, y, size.width, size.height};
}

}  // namespace

PixelRect draw_color_bar(Overlay& overlay, const PixelRect& bar,
                         const std::function<Rgba8(double)>& color, std::string_view title,
                         std::span<const Tick> ticks, const FigureStyle& style) {
    const bool vertical = bar.height > bar.width;
    const int length = vertical ? bar.height : bar.width;
    const auto at = [&](int i) { return length > 1 ? static_cast<double>(i) / (length - 1) : 0; };
    for (int i = 0; i < length; ++i)
        overlay.rectangle(vertical ? PixelRect{bar.x, bar.y + bar.height - 1 - i, bar.width, 1}
                                   : PixelRect{bar.x + i, bar.y, 1, bar.height},
                          color(at(i)));
    overlay.frame(bar, style.theme.border);

    PixelRect covered = bar;
    const int tick_length = std::max(3, style.unit / 4);
    int free_from = bar.x;
    for (const Tick& tick : ticks) {
        const int i = static_cast<int>(std::lround(std::clamp(tick.at, 0.0, 1.0) * (length - 1)));
        if (vertical) {
            const int y = bar.y + bar.height - 1 - i;
            overlay.rectangle({bar.x + bar.width, y, tick_length, 1}, style.theme.faint_text);
            covered =
                together(covered, write(overlay, bar.x + bar.width + 2 * tick_length,
                                        y - small_size(style.unit) / 2, tick.label, body(style)));
        } else {
            overlay.rectangle({bar.x + i, bar.y + bar.height, 1, tick_length},
                              style.theme.faint_text);
            const int width = overlay.measure(tick.label, body(style)).width;
            const int x =
                std::max(bar.x, std::min(bar.x + i - width / 2, bar.x + bar.width - width));
            if (x < free_from) continue;
            free_from = x + width + style.unit / 4;
            covered = together(covered, write(overlay, x, bar.y + bar.height + tick_length + 1,
                                              tick.label, body(style)));
        }
    }
    if (!title.empty())
        covered = together(
            covered, write(overlay, bar.x, covered.y - line_height(style), title, heading(style)));
    return covered;
}

PixelRect draw_stacked_bar(Overlay& overlay, const PixelRect& rect, std::span<const BarPart> parts,
                           double full) {
    const bool vertical = rect.height > rect.width;
    const int length = vertical ? rect.height : rect.width;
    double sum = 0;
    int begin = 0;
    for (const BarPart& part : parts) {
        sum += part.amount;
        const int end =
            full > 0 ? static_cast<int>(std::lround(std::clamp(sum / full, 0.0, 1.0) * length)) : 0;
        overlay.rectangle(
            vertical ? PixelRect{rect.x, rect.y + rect.height - end, rect.width, end - begin}
                     : PixelRect{rect.x + begin, rect.y, end - begin, rect.height},
            part.color);
        begin = end;
    }
    return rect;
}

PixelRect draw_scale_bar(Overlay& overlay, int x, int y, int largest_width, double pixels_per_unit,
                         const FigureStyle& style) {
    const double largest = largest_width / pixels_per_unit;
    if (!(largest > 1e-300) || !(largest < 1e300)) return {x, y, 0, 0};
    double power = 1;
    while (power > largest) power /= 10;
    while (power * 10 <= largest) power *= 10;
    const double value = power * (5 * power <= largest ? 5 : (2 * power <= largest ? 2 : 1));
    const int width = static_cast<int>(std::lround(value * pixels_per_unit));
    const std::string label = format("%g", value);

    const int end = std::max(4, style.unit / 3), thickness = std::max(1, style.unit / 10);
    // A panel, so that it is legible in front of any subject.
    const int label_width = overlay.measure(label, body(style)).width, edge = style.unit / 4;
    const int left = std::min(x, x + (width - label_width) / 2) - edge;
    const PixelRect panel{left, y - end - line_height(style) - edge, 2 * (x - left) + width,
                          end + line_height(style) + 2 * edge};
    overlay.rectangle(panel, style.theme.panel);
    overlay.rectangle({x, y - end / 2 - thickness, width, thickness}, style.theme.text);
    overlay.rectangle({x, y - end, thickness, end}, style.theme.text);
    overlay.rectangle({x + width - thickness, y - end, thickness, end}, style.theme.text);
    const PixelRect text = write(overlay, x + width / 2, y - end - line_height(style), label,
                                 aligned(body(style), Align::center));
    return together(panel, text);
}

}  // namespace scb::render
