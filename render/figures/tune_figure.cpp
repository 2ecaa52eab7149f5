#include "render/figures/tune_figure.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/pass_counts.h"
#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/bar_plot.h"
#include "render/view/palette.h"

namespace scb::render {
namespace {

const Rgba8 n_v_color = category_color(0), cost_color = category_color(1),
            time_color = category_color(2);

bool is_timed(const TuneFigure& figure) {
    return std::any_of(figure.bars.begin(), figure.bars.end(),
                       [](const TuneBar& bar) { return bar.time.has_value(); });
}

bool has_packed(const TuneFigure& figure) {
    return std::any_of(figure.bars.begin(), figure.bars.end(),
                       [](const TuneBar& bar) { return bar.packed; });
}

std::string multiple_text(double ratio) {
    return format("%.*f", ratio >= 100 ? 0 : ratio >= 0.1 ? 2 : 3, ratio);
}

/// The bar of the recommended setting is in full color.
PlotBar bar_of(const TuneFigure& figure, std::size_t i, Rgba8 color, double value,
               std::string number) {
    const TuneBar& bar = figure.bars[i];
    if (bar.misses_pairs) number += ", misses pairs";
    PlotBar plotted{bar.name, bar.recommended ? color : mix(color, figure.theme->background, 0.5),
                    value, std::move(number)};
    plotted.marked = bar.recommended;
    plotted.apart = bar.packed && i > 0 && !figure.bars[i - 1].packed;
    return plotted;
}

BarPlot plot_of_tests(const TuneFigure& figure) {
    BarPlot plot;
    plot.title = "volume tests, N_v";
    plot.label = "mean per frame, base = 1";
    for (std::size_t i = 0; i < figure.bars.size(); ++i) {
        const double n_v = figure.bars[i].n_v;
        plot.bars.push_back(bar_of(figure, i, n_v_color, n_v, multiple_text(n_v)));
    }
    return plot;
}

/// `is_best`: whether the recommended setting has the least cost.
BarPlot plot_of_costs(const TuneFigure& figure, bool is_best) {
    BarPlot plot;
    plot.title = "cost";
    plot.label = std::string(cost_words) + ", base = 1";
    for (std::size_t i = 0; i < figure.bars.size(); ++i) {
        const TuneBar& bar = figure.bars[i];
        plot.bars.push_back(
            bar.cost
                ? bar_of(figure, i, cost_color, *bar.cost,
                         multiple_text(*bar.cost) + (bar.recommended && is_best ? ", best" : ""))
                : bar_of(figure, i, cost_color, std::nan(""), "not counted: packed"));
    }
    return plot;
}

std::string time_text(const TuneFigure& figure, const TuneBar& bar) {
    std::string text = multiple_text(bar.time->median);
    if (figure.runs > 1)
        text +=
            " (" + multiple_text(bar.time->least) + " to " + multiple_text(bar.time->most) + ")";
    if (bar.recommended) return text + (has_packed(figure) ? ", best unpacked" : ", best");
    return text + (bar.packed ? ", best packed" : bar.alike ? ", no difference" : "");
}

BarPlot plot_of_times(const TuneFigure& figure) {
    BarPlot plot;
    plot.title = "time";
    plot.label =
        std::string("processor time of a query, base = 1") +
        (figure.runs > 1 ? ": median, least to most of " + std::to_string(figure.runs) + " runs"
                         : ": one run");
    for (std::size_t i = 0; i < figure.bars.size(); ++i) {
        const TuneBar& bar = figure.bars[i];
        if (!bar.time) {
            plot.bars.push_back(bar_of(figure, i, time_color, std::nan(""), "not timed"));
            continue;
        }
        plot.bars.push_back(
            bar_of(figure, i, time_color, bar.time->median, time_text(figure, bar)));
        if (figure.runs > 1) plot.bars.back().range = {bar.time->least, bar.time->most};
    }
    return plot;
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
    const int gap = unit, room = bottom - top - footnote_height - unit / 2,
              for_bars = frame.portrait ? (room - gap) / 2 : room,
              least = static_cast<int>(figure.bars.size()) * (small_size(unit) + 1) + 3 * unit;
    // Bars have priority over small print.
    if (for_bars >= least) {
        int y = bottom - footnote_height;
        for (const std::string& text : footnote) {
            overlay.text(margin, y, text, faint);
            y += line;
        }
        bottom -= footnote_height + unit / 2;
    }

    const bool timed = is_timed(figure);
    const BarPlot first = timed ? plot_of_costs(figure, false) : plot_of_tests(figure);
    BarPlot second = timed ? plot_of_times(figure) : plot_of_costs(figure, true);
    PixelRect before{margin, top, width - 2 * margin, bottom - top};
    PixelRect beside = before;
    if (frame.portrait) {
        before.height = beside.height = (before.height - gap) / 2;
        beside.y += before.height + gap;
    } else {
        // Rows are at the same height in both, so that the names at the left are valid for both.
        before.width = (before.width - gap) * 3 / 5;
        beside.x += before.width + gap;
        beside.width -= before.width + gap;
        for (PlotBar& bar : second.bars) bar.name.clear();
    }
    draw_bar_plot(overlay, before, first, style);
    draw_bar_plot(overlay, beside, second, style);
    return picture;
}

}  // namespace scb::render
