#include "render/plots/bar_plot.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"

namespace scb::render {
namespace {

bool drawable(const PlotBar& bar) { return std::isfinite(bar.value) && bar.value >= 0; }

double end_of(const PlotBar& bar) { return bar.range ? bar.range->second : bar.value; }

}  // namespace

PixelRect draw_bar_plot(Overlay& overlay, const PixelRect& rect, const BarPlot& plot,
                        const FigureStyle& style) {
    const int unit = style.unit, small = small_size(unit), heading = unit * 5 / 4;
    const TextStyle bold{unit, FontWeight::bold, style.theme.text};
    const TextStyle faint{small, FontWeight::regular, style.theme.faint_text};
    const int top = 2 * heading + unit / 4, count = std::max(1, static_cast<int>(plot.bars.size()));
    // Bars far apart do not look like one figure; many have smaller text.
    const int row = std::min((rect.height - top) / count, 6 * unit),
              text_size = std::clamp(row - 1, std::min(small, 8), small);
    const TextStyle name{text_size, FontWeight::regular, style.theme.text};
    const TextStyle number{text_size, FontWeight::bold, style.theme.text};
    const bool empty = std::none_of(plot.bars.begin(), plot.bars.end(), drawable);

    int names = 0, numbers = 0;
    double largest = 0;
    for (const PlotBar& bar : plot.bars) {
        names = std::max(names, overlay.measure(bar.name, bar.marked ? number : name).width);
        numbers = std::max(numbers, overlay.measure(bar.number, number).width);
        if (drawable(bar)) largest = std::max({largest, bar.value, end_of(bar)});
    }
    const int gap = unit / 2;
    // A name may be cut, but not a number.
    names = std::min(names, rect.width * 9 / 20);
    PixelRect area{rect.x + names + gap, rect.y + top, rect.width - names - numbers - 2 * gap,
                   rect.height - top};
    if (area.width < 2 * unit || row < text_size + 1) return {rect.x, rect.y, 0, 0};
    area.height = row * count;

    overlay.text(rect.x, rect.y, fitted_text(overlay, plot.title, bold, rect.width), bold);
    overlay.text(rect.x, rect.y + heading, fitted_text(overlay, plot.label, faint, rect.width),
                 faint);
    if (empty) {
        TextStyle middle = faint;
        middle.align = Align::center;
        overlay.text(rect.x + rect.width / 2, area.y + (area.height - small) / 2,
                     fitted_text(overlay, plot.empty_text, middle, rect.width), middle);
        return area;
    }
    const int thickness = std::clamp(row * 3 / 5, 2, 5 * unit / 2),
              hairline = std::max(1, unit / 20);
    for (int i = 0; i < static_cast<int>(plot.bars.size()); ++i) {
        const PlotBar& bar = plot.bars[static_cast<std::size_t>(i)];
        const int middle = area.y + i * row + row / 2, text = middle - text_size / 2;
        const PixelRect whole_row{rect.x, area.y + i * row, rect.width, row};
        if (bar.marked)
            overlay.rectangle(whole_row, mix(style.theme.border, style.theme.background, 0.7));
        if (bar.apart)
            overlay.rectangle({rect.x, whole_row.y, rect.width, hairline}, style.theme.faint_text);
        TextStyle right = bar.marked ? number : name;
        right.align = Align::right;
        overlay.text(area.x - gap, text, fitted_text(overlay, bar.name, right, names), right);
        const auto length_of = [&](double value) {
            return drawable(bar) && largest > 0
                       ? static_cast<int>(std::lround(value / largest * area.width))
                       : 0;
        };
        overlay.rectangle({area.x, middle - thickness / 2, length_of(bar.value), thickness},
                          bar.color);
        if (bar.range) {
            const int from = area.x + length_of(bar.range->first),
                      to = area.x + length_of(bar.range->second), cap = thickness / 2;
            overlay.rectangle({from, middle, std::max(hairline, to - from), hairline},
                              style.theme.text);
            for (const int end : {from, to})
                overlay.rectangle({end, middle - cap / 2, hairline, cap}, style.theme.text);
        }
        overlay.text(area.x + length_of(end_of(bar)) + gap, text, bar.number, number);
    }
    // The line where bars begin.
    overlay.rectangle({area.x, area.y, hairline, area.height}, style.theme.faint_text);
    return area;
}

}  // namespace scb::render
