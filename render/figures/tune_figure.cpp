#include "render/figures/tune_figure.h"

#include <algorithm>
#include <cstdio>

#include "render/overlay/figure_layout.h"
#include "render/plots/bar_plot.h"
#include "render/view/palette.h"

namespace scb::render {
namespace {

const Rgba8 n_v_color = category_color(0), operations_color = category_color(1),
            time_color = category_color(2);

bool is_timed(const TuneFigure& figure) {
    return std::any_of(figure.bars.begin(), figure.bars.end(),
                       [](const TuneBar& bar) { return bar.time.has_value(); });
}

// The best bars are in full color.
Rgba8 bar_color(Rgba8 color, bool best, const Theme& theme) {
    return best ? color : mix(color, theme.background, 0.5);
}

std::string multiple_text(double ratio) {
    char text[32];
    std::snprintf(text, sizeof text, ratio >= 100 ? "%.0f" : ratio >= 0.1 ? "%.2f" : "%.3f", ratio);
    return text;
}

std::string bar_text(const std::string& value, const TuneBar& bar, bool best) {
    return value + (best ? ", best" : "") + (bar.misses_pairs ? ", misses pairs" : "");
}

BarPlot plot_of_counts(const TuneFigure& figure, const char* title, Rgba8 color,
                       double TuneBar::*count, bool TuneBar::*fewest) {
    BarPlot plot;
    plot.title = title;
    plot.label = "mean per frame, base = 1";
    for (const TuneBar& bar : figure.bars)
        plot.bars.push_back({bar.name, bar_color(color, bar.*fewest, *figure.theme), bar.*count,
                             bar_text(multiple_text(bar.*count), bar, bar.*fewest)});
    return plot;
}

BarPlot plot_of_tests(const TuneFigure& figure) {
    return plot_of_counts(figure, "volume tests, N_v", n_v_color, &TuneBar::n_v,
                          &TuneBar::fewest_tests);
}

BarPlot plot_of_operations(const TuneFigure& figure) {
    return plot_of_counts(figure, "operations of the volume tests", operations_color,
                          &TuneBar::operations, &TuneBar::fewest_operations);
}

BarPlot plot_of_times(const TuneFigure& figure) {
    BarPlot plot;
    plot.title = "time";
    plot.label = "processor time of a query, base = 1: median of the runs, least to most";
    for (const TuneBar& bar : figure.bars)
        if (bar.time)
            plot.bars.push_back(
                {bar.name, bar_color(time_color, bar.least_time, *figure.theme), bar.time->median,
                 bar_text(multiple_text(bar.time->median) + " (" + multiple_text(bar.time->least) +
                              " to " + multiple_text(bar.time->most) + ")",
                          bar, bar.least_time)});
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
    // Bars before small print.
    if (for_bars >= least) {
        int y = bottom - footnote_height;
        for (const std::string& text : footnote) {
            overlay.text(margin, y, text, faint);
            y += line;
        }
        bottom -= footnote_height + unit / 2;
    }

    PixelRect tests{margin, top, width - 2 * margin, bottom - top};
    PixelRect beside = tests;
    if (frame.portrait) {
        tests.height = beside.height = (tests.height - gap) / 2;
        beside.y += tests.height + gap;
    } else {
        tests.width = beside.width = (tests.width - 2 * gap) / 2;
        beside.x += tests.width + 2 * gap;
    }
    draw_bar_plot(overlay, tests, plot_of_tests(figure), style);
    draw_bar_plot(overlay, beside,
                  is_timed(figure) ? plot_of_times(figure) : plot_of_operations(figure), style);
    return picture;
}

}  // namespace scb::render
