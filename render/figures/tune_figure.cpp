#include "render/figures/tune_figure.h"

#include <algorithm>
#include <cstdio>

#include "render/overlay/figure_layout.h"
#include "render/plots/bar_plot.h"
#include "render/plots/line_plot.h"
#include "render/view/palette.h"

namespace scb::render {
namespace {

const Rgba8 n_v_color = category_color(0), operations_color = category_color(1),
            time_color = category_color(2);

bool is_timed(const TuneFigure& figure) {
    return std::any_of(figure.bars.begin(), figure.bars.end(),
                       [](const TuneBar& bar) { return bar.costs.time.has_value(); });
}

LinePlot line_plot_of(const TuneFigure& figure) {
    LinePlot plot;
    plot.title = "corrected, over its threshold a";
    plot.y_label = "mean per frame, base = 1";
    plot.x_label = "a";
    plot.scale = PlotScale::linear;
    plot.legend = PlotLegend::below;
    plot.from_zero = false;
    const auto add = [&](const char* name, Rgba8 color, LineStroke stroke, const auto& value) {
        PlotSeries series{name, "", color, stroke, figure.thresholds, {}};
        for (const TuneCosts& costs : figure.over_threshold) series.y.push_back(value(costs));
        plot.series.push_back(std::move(series));
    };
    add("base", figure.theme->faint_text, LineStroke::dotted, [](const TuneCosts&) { return 1.0; });
    add("N_v", n_v_color, LineStroke::solid, [](const TuneCosts& c) { return c.n_v; });
    add("operations", operations_color, LineStroke::dashed,
        [](const TuneCosts& c) { return c.operations; });
    if (is_timed(figure))
        add("time", time_color, LineStroke::solid, [](const TuneCosts& c) { return *c.time; });
    return plot;
}

// The best bars are in full color.
Rgba8 bar_color(Rgba8 color, bool best, const Theme& theme) {
    return best ? color : mix(color, theme.background, 0.5);
}

std::string ratio_text(double ratio, const TuneBar& bar, bool best) {
    char text[32];
    std::snprintf(text, sizeof text, ratio < 100 ? "%.2f" : "%.0f", ratio);
    return std::string(text) + (best ? ", best" : bar.misses_pairs ? ", misses pairs" : "");
}

BarPlot bar_plot_of(const TuneFigure& figure, bool of_time) {
    BarPlot plot;
    plot.title = of_time ? "time" : "operations of the volume tests";
    plot.label = of_time ? "processor time of a query, base = 1" : "base = 1";
    for (const TuneBar& bar : figure.bars) {
        const double value = of_time ? bar.costs.time.value_or(0) : bar.costs.operations;
        const bool best = of_time ? bar.least_time : bar.fewest_operations;
        plot.bars.push_back(
            {bar.name, bar_color(of_time ? time_color : operations_color, best, *figure.theme),
             value, ratio_text(value, bar, best)});
    }
    return plot;
}

/// The least height with which draw_bar_plot draws them.
int least_height(const TuneFigure& figure, int bar_plots, int unit) {
    const int rows = static_cast<int>(figure.bars.size()) * (small_size(unit) + 1);
    return bar_plots * (2 * (unit * 5 / 4) + unit / 4 + rows) + (bar_plots - 1) * unit;
}

/// Rectangles above each other, of equal height.
std::vector<PixelRect> stacked(const PixelRect& rect, int count, int gap) {
    std::vector<PixelRect> parts;
    const int each = (rect.height - (count - 1) * gap) / count;
    for (int i = 0; i < count; ++i)
        parts.push_back({rect.x, rect.y + i * (each + gap), rect.width, each});
    return parts;
}

}  // namespace

Picture compose(const TuneFigure& figure, int width, int height, Overlay& overlay) {
    const FigureLayout frame = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    const int unit = frame.unit, margin = frame.heading.x, small = std::max(10, unit * 7 / 10);
    const FigureStyle style{theme, unit};
    const Picture picture{width, height, 1, theme.background, {}};
    overlay.begin();
    draw_heading(overlay, frame, theme, figure.title, figure.subtitle);

    const int top = frame.heading.y + frame.heading.height + unit / 2;
    int bottom = height - margin;
    const TextStyle faint{small, FontWeight::regular, theme.faint_text};
    const std::vector<std::string> footnote =
        wrapped_text(overlay, figure.footnote, faint, frame.heading.width);
    const int line = small * 5 / 4, footnote_height = static_cast<int>(footnote.size()) * line;
    const int bar_plots = is_timed(figure) ? 2 : 1, gap = unit;
    const int room = bottom - top - footnote_height - unit / 2,
              for_bars = frame.portrait ? (room - gap) * bar_plots / (bar_plots + 1) : room;
    // Bars before small print.
    if (for_bars >= least_height(figure, bar_plots, unit)) {
        int y = bottom - footnote_height;
        for (const std::string& text : footnote) {
            overlay.text(margin, y, text, faint);
            y += line;
        }
        bottom -= footnote_height + unit / 2;
    }

    const PixelRect inside{margin, top, width - 2 * margin, bottom - top};
    PixelRect lines = inside, bars = inside;
    if (figure.thresholds.empty()) {
        lines.height = 0;
    } else if (frame.portrait) {
        lines.height = (inside.height - gap) / (bar_plots + 1);
        bars.y += lines.height + gap;
        bars.height -= lines.height + gap;
    } else {
        lines.width = (inside.width - 2 * gap) / 2;
        bars.x += lines.width + 2 * gap;
        bars.width -= lines.width + 2 * gap;
    }
    if (lines.height > 0) draw_line_plot(overlay, lines, line_plot_of(figure), style);
    const std::vector<PixelRect> places = stacked(bars, bar_plots, gap);
    for (int i = 0; i < bar_plots; ++i)
        draw_bar_plot(overlay, places[static_cast<std::size_t>(i)],
                      bar_plot_of(figure, bar_plots == 2 && i == 1), style);
    return picture;
}

}  // namespace scb::render
