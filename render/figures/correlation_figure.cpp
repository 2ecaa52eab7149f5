#include "render/figures/correlation_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/plot_axis.h"
#include "render/view/palette.h"

namespace scb::render {
namespace {

std::string correlation_number(double value) {
    if (!std::isfinite(value)) return "–";
    return (value <= -0.005 ? "−" : "") +
           format("%.2f", std::abs(value) < 0.005 ? 0.0 : std::abs(value));
}

// From 0, or the half step below the least value, to 1.
PlotAxis correlation_axis(const CorrelationFigure& figure) {
    PlotAxis axis{0, 1, false, false, {}};
    for (const CorrelationPlot& plot : figure.plots)
        for (const CorrelationRow& row : plot.rows)
            for (const double value : row.of_scene)
                while (value < axis.low) axis.low -= 0.5;
    for (double value = axis.low; value <= 1; value += 0.5)
        axis.ticks.push_back({value, correlation_number(value)});
    return axis;
}

void draw_disc(Overlay& overlay, double x, double y, double radius, Rgba8 color) {
    std::array<ScreenPosition, 24> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const SinCos angle = sin_cos_turns(static_cast<double>(i) / corners.size());
        corners[i] = {x + radius * angle.cos, y + radius * angle.sin};
    }
    overlay.polygon(corners, color);
}

void draw_rows(Overlay& overlay, const PixelRect& rect, const CorrelationFigure& figure,
               const CorrelationPlot& plot, const FigureStyle& style) {
    const int unit = style.unit;
    const TextStyle name{unit, FontWeight::regular, style.theme.text};
    TextStyle number{unit, FontWeight::bold, style.theme.text};
    number.align = Align::right;
    int names = 0;
    for (const CorrelationRow& row : plot.rows)
        names = std::max(names, overlay.measure(row.name, name).width);
    names = std::min(names, rect.width * 9 / 20);
    const int numbers = overlay.measure(correlation_number(-0.88), number).width, gap = unit / 2;
    const PixelRect data{rect.x + names + gap, rect.y + unit * 3 / 2,
                         rect.width - names - numbers - 2 * gap, rect.height - unit * 4};
    const int count = std::max(1, static_cast<int>(plot.rows.size())),
              row_height = data.height / count;
    if (data.width < 4 * unit || row_height < unit) return;
    overlay.text(
        rect.x, rect.y,
        fitted_text(overlay, plot.title, {unit, FontWeight::bold, style.theme.text}, rect.width),
        {unit, FontWeight::bold, style.theme.text});
    const PlotAxis axis = correlation_axis(figure);
    const auto x_of = [&](double value) {
        return data.x + axis_position(axis, value) * data.width;
    };
    const int bottom = data.y + row_height * count;
    TextStyle label{small_size(unit), FontWeight::regular, style.theme.faint_text};
    label.align = Align::center;
    for (const AxisTick& tick : axis.ticks) {
        const int x = static_cast<int>(std::lround(x_of(tick.value)));
        const bool zero = tick.value == 0;
        overlay.rectangle({x, data.y, zero ? std::max(2, unit / 10) : 1, bottom - data.y},
                          zero ? style.theme.faint_text : style.theme.border);
        overlay.text(x, bottom + unit / 4, tick.label, label);
    }
    overlay.text(data.x + data.width / 2, bottom + unit * 5 / 4, "rank correlation within a scene",
                 label);
    const Rgba8 dot = with_opacity(category_color(0), 0.45), bar = category_color(3);
    for (int i = 0; i < count && !plot.rows.empty(); ++i) {
        const CorrelationRow& row = plot.rows[static_cast<std::size_t>(i)];
        const int middle = data.y + i * row_height + row_height / 2, text = middle - unit / 2;
        TextStyle right = name;
        right.align = Align::right;
        overlay.text(rect.x + names, text, fitted_text(overlay, row.name, name, names), right);
        for (const double value : row.of_scene)
            if (std::isfinite(value)) draw_disc(overlay, x_of(value), middle, unit * 0.3, dot);
        if (std::isfinite(row.mean)) {
            const int width = std::max(3, unit / 5),
                      height = std::min(row_height * 3 / 4, unit * 3 / 2);
            overlay.rectangle({static_cast<int>(std::lround(x_of(row.mean))) - width / 2,
                               middle - height / 2, width, height},
                              bar);
        }
        overlay.text(rect.x + rect.width, text, correlation_number(row.mean), number);
    }
}

// Draws the meaning of dots and bars, in lines of this width. Returns the y of its end.
int draw_key(Overlay& overlay, int x, int y, int width, const FigureStyle& style) {
    const int unit = style.unit, right = x + width;
    const TextStyle text{unit, FontWeight::regular, style.theme.text};
    const std::string scene = "a scene";
    const int scene_width = overlay.measure(scene, text).width;
    if (width < scene_width + 10 * unit) return y;
    draw_disc(overlay, x + unit * 0.4, y + unit * 0.5, unit * 0.3,
              with_opacity(category_color(0), 0.45));
    overlay.text(x + unit, y, scene, text);
    x += unit * 2 + scene_width;
    overlay.rectangle({x, y, std::max(3, unit / 5), unit}, category_color(3));
    x += unit / 2;
    for (const std::string& line :
         wrapped_text(overlay,
                      "their mean, also as a number. 1: the cheaper the query, the smaller the "
                      "measure, without exception; 0: no relation",
                      text, right - x)) {
        overlay.text(x, y, line, text);
        y += unit * 5 / 4;
    }
    return y;
}

}  // namespace

Picture compose(const CorrelationFigure& figure, int width, int height, Overlay& overlay) {
    const FigureLayout frame = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    const int unit = frame.unit, margin = frame.heading.x, small = std::max(10, unit * 7 / 10);
    const FigureStyle style{theme, unit};
    overlay.begin();
    draw_heading(overlay, frame, theme, figure.title, figure.subtitle);
    int top = frame.heading.y + frame.heading.height + unit / 2, bottom = height - margin;
    // Small pictures have room for the plots alone.
    if (height > 20 * unit) top = draw_key(overlay, margin, top, width - 2 * margin, style) + unit;
    const TextStyle faint{small, FontWeight::regular, theme.faint_text};
    const std::vector<std::string> footnote =
        wrapped_text(overlay, figure.footnote, faint, frame.heading.width);
    const int line = small * 5 / 4, footnote_height = static_cast<int>(footnote.size()) * line;
    if (bottom - top - footnote_height > 16 * unit * (frame.portrait ? 2 : 1)) {
        for (std::size_t i = 0; i < footnote.size(); ++i)
            overlay.text(margin, bottom - footnote_height + static_cast<int>(i) * line, footnote[i],
                         faint);
        bottom -= footnote_height + unit / 2;
    }
    const int plots = std::max(1, static_cast<int>(figure.plots.size())), gap = 2 * unit;
    PixelRect rect{margin, top, width - 2 * margin, bottom - top};
    if (frame.portrait)
        rect.height = (rect.height - gap * (plots - 1)) / plots;
    else
        rect.width = (rect.width - gap * (plots - 1)) / plots;
    for (const CorrelationPlot& plot : figure.plots) {
        draw_rows(overlay, rect, figure, plot, style);
        if (frame.portrait)
            rect.y += rect.height + gap;
        else
            rect.x += rect.width + gap;
    }
    return Picture{width, height, 1, theme.background, {}};
}

}  // namespace scb::render
