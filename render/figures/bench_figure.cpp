#include "render/figures/bench_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/statistics.h"
#include "render/figures/bench_legend.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/bar_plot.h"
#include "render/plots/line_plot.h"

namespace scb::render {
namespace {

/// One of the two plots: its values and its name.
struct Measure {
    const char* title;
    const char* unit;  ///< of the values
    const char* empty_text;
    std::vector<double> BenchSeries::*values;
};

constexpr Measure counts_measure = {"Volume pair tests", "N_v", "no data", &BenchSeries::n_v};
constexpr Measure times_measure = {"Time", "ms", "not measured", &BenchSeries::ms};

// The order in which lines are drawn: lines of the SCB over the others, sparser over fuller ones.
std::vector<std::size_t> drawing_order(const BenchFigure& figure,
                                       const std::vector<SeriesLook>& looks) {
    std::vector<std::size_t> order;
    for (std::size_t row = 0; row < figure.series.size(); ++row) order.push_back(row);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto layer = [&](std::size_t row) {
            return std::pair(figure.series[row].kind == VolumeKind::scb, looks[row].stroke);
        };
        return layer(a) < layer(b);
    });
    return order;
}

LinePlot line_plot_of(const BenchFigure& figure, const Measure& measure) {
    LinePlot plot;
    plot.title = measure.title;
    plot.y_label = std::string(measure.unit) + " per frame";
    plot.empty_text = measure.empty_text;
    plot.x_label = "frame";
    plot.ranges = figure.ranges;
    plot.whole_x = true;
    const std::vector<SeriesLook> looks = looks_of(figure);
    for (const std::size_t row : drawing_order(figure, looks)) {
        const BenchSeries& series = figure.series[row];
        PlotSeries line{series_label(figure, row),
                        "",
                        looks[row].color,
                        looks[row].stroke,
                        {series.frames.begin(), series.frames.end()},
                        series.*measure.values};
        // Unknown frames are gaps, and both plots have the same frames.
        line.y.resize(line.x.size(), std::numeric_limits<double>::quiet_NaN());
        plot.series.push_back(std::move(line));
    }
    return plot;
}

BarPlot bar_plot_of(const BenchFigure& figure, const Measure& measure) {
    const std::vector<int> frames = frames_of(figure);
    BarPlot plot;
    plot.title = measure.title;
    plot.label = std::string(measure.unit) + (frames.size() > 1 ? ", mean of " : " in ") +
                 frames_text(frames);
    plot.empty_text = measure.empty_text;
    const std::vector<SeriesLook> looks = looks_of(figure);
    for (std::size_t row = 0; row < figure.series.size(); ++row) {
        const double value = mean(figure.series[row].*measure.values);
        plot.bars.push_back({series_label(figure, row), looks[row].color, value,
                             std::isfinite(value) ? number_text(value) : "–"});
    }
    return plot;
}

std::string subtitle_of(const BenchFigure& figure) {
    std::string text;
    for (const std::uint64_t count : figure.triangles)
        text += (text.empty() ? "" : " + ") + count_text(count);
    if (!text.empty()) text += " triangles";
    const std::string frames = frames_text(frames_of(figure));
    return text + (text.empty() || frames.empty() ? "" : ", ") + frames;
}

/// The lines at the bottom, which a reader needs to repeat the figure, but not to understand it.
struct Footnote {
    std::vector<std::string> lines;
    TextStyle style;

    int line_height() const { return style.size * 5 / 4; }
    int height() const { return static_cast<int>(lines.size()) * line_height(); }
    void draw(Overlay& overlay, const PixelRect& rect) const {
        int y = rect.y + rect.height - height();
        for (const std::string& line : lines) {
            overlay.text(rect.x, y, line, style);
            y += line_height();
        }
    }
};

Footnote footnote_of(Overlay& overlay, const BenchFigure& figure, const FigureLayout& layout) {
    Footnote footnote;
    footnote.style = {std::max(10, layout.unit * 7 / 10), FontWeight::regular,
                      figure.theme->faint_text};
    footnote.lines = wrapped_text(overlay, figure.footnote, footnote.style, layout.heading.width);
    return footnote;
}

struct BenchLayout {
    PixelRect left, right;  ///< the plots
    PixelRect legend, footnote;
    int legend_text = 0;  ///< size of its text; 0: no legend
};

BenchLayout layout_of(const FigureLayout& frame, int width, int height, const BenchLegend& legend,
                      int footnote_height) {
    BenchLayout layout;
    const int unit = frame.unit, margin = frame.heading.x;
    const int inside = width - 2 * margin, gutter = 2 * unit;
    const int top = frame.heading.y + frame.heading.height + unit / 2;
    int bottom = height - margin;
    // Bars have names and numbers of their own, so they get their room before the table; else no
    // bars would be drawn.
    const int bars = static_cast<int>(legend.rows.size()) * (small_size(unit) + 1) + 13 * unit / 4,
              plots = frame.portrait ? 2 : 1,
              least = plots * (legend.blocks ? std::max(9 * unit, bars) : 9 * unit);
    const auto room = [&](int text) {
        const int table = text > 0 ? bench_legend_height(legend, text) + unit : 0;
        return bottom - top - table - (footnote_height > 0 ? footnote_height + unit / 4 : 0);
    };
    const int smallest = std::max(10, unit * 3 / 4);
    layout.legend_text = legend.rows.empty() ? 0 : unit;
    while (layout.legend_text > smallest && room(layout.legend_text) < least) --layout.legend_text;
    if (room(layout.legend_text) < least) footnote_height = 0;
    if (room(layout.legend_text) < least) layout.legend_text = 0;

    layout.footnote = {margin, bottom - footnote_height, inside, footnote_height};
    if (footnote_height > 0) bottom -= footnote_height + unit / 4;
    if (layout.legend_text > 0) {
        const int table = bench_legend_height(legend, layout.legend_text);
        layout.legend = {margin, bottom - table, inside, table};
        bottom -= table + unit / 2;
    }
    if (frame.portrait) {
        const int each = (bottom - top - unit) / 2;
        layout.left = {margin, top, inside, each};
        layout.right = {margin, bottom - each, inside, each};
    } else {
        const int each = (inside - gutter) / 2;
        layout.left = {margin, top, each, bottom - top};
        layout.right = {width - margin - each, top, each, bottom - top};
    }
    return layout;
}

void draw_lines(Overlay& overlay, const BenchFigure& figure, const BenchLayout& layout,
                const FigureStyle& style) {
    LinePlot counts = line_plot_of(figure, counts_measure);
    LinePlot times = line_plot_of(figure, times_measure);
    // The plots are read side by side: time has the scale of the counts.
    counts.scale = times.scale = chosen_scale(counts);
    if (layout.legend_text == 0) counts.legend = times.legend = PlotLegend::below;
    draw_line_plot(overlay, layout.left, counts, style);
    draw_line_plot(overlay, layout.right, times, style);
}

void draw_bars(Overlay& overlay, const BenchFigure& figure, BenchLayout layout,
               const FigureStyle& style) {
    // Bars have no marks and labels below that would keep them apart from the legend.
    for (PixelRect* rect : {&layout.left, &layout.right}) rect->height -= style.unit / 2;
    draw_bar_plot(overlay, layout.left, bar_plot_of(figure, counts_measure), style);
    draw_bar_plot(overlay, layout.right, bar_plot_of(figure, times_measure), style);
}

}  // namespace

std::vector<int> frames_of(const BenchFigure& figure) {
    std::set<int> frames;
    for (const BenchSeries& series : figure.series)
        frames.insert(series.frames.begin(), series.frames.end());
    return {frames.begin(), frames.end()};
}

std::string frames_text(const std::vector<int>& frames) {
    if (frames.empty()) return "";
    const std::string first = std::to_string(frames.front()), last = std::to_string(frames.back());
    if (frames.size() == 1) return "frame " + first;
    if (frames.size() == 2) return "frames " + first + " and " + last;
    if (frames.size() < least_frames_of_lines) {
        std::string text = "frames " + first;
        for (std::size_t i = 1; i + 1 < frames.size(); ++i)
            text += ", " + std::to_string(frames[i]);
        return text + " and " + last;
    }
    const auto count = static_cast<std::int64_t>(frames.size());
    if (count == std::int64_t{frames.back()} - frames.front() + 1)
        return "frames " + first + " to " + last;
    return std::to_string(count) + " frames, " + first + " to " + last;
}

std::optional<double> time_over_scb(const BenchSeries& scb, const BenchSeries& other, double from,
                                    double to) {
    std::map<int, double> times;
    for (std::size_t i = 0; i < std::min(scb.frames.size(), scb.ms.size()); ++i)
        if (std::isfinite(scb.ms[i])) times[scb.frames[i]] = scb.ms[i];
    double ours = 0, theirs = 0;
    for (std::size_t i = 0; i < std::min(other.frames.size(), other.ms.size()); ++i) {
        const auto same = times.find(other.frames[i]);
        if (same == times.end() || !std::isfinite(other.ms[i])) continue;
        if (!(same->first >= from && same->first <= to)) continue;
        ours += same->second;
        theirs += other.ms[i];
    }
    if (!(ours > 0)) return std::nullopt;
    return theirs / ours;
}

Picture compose(const BenchFigure& full, int width, int height, Overlay& overlay) {
    const std::size_t frames = frames_of(full).size();
    const bool bars = frames > 0 && frames < least_frames_of_lines;
    BenchFigure figure = full;
    // Bars have no frames to shade.
    if (bars) figure.ranges.clear();
    const Theme& theme = *figure.theme;
    overlay.begin();
    const FigureLayout frame = figure_layout(width, height);
    const FigureStyle style{theme, frame.unit};
    BenchLegend legend = bench_legend(figure);
    legend.blocks = bars;
    const Footnote footnote = footnote_of(overlay, figure, frame);
    const BenchLayout layout = layout_of(frame, width, height, legend, footnote.height());

    draw_heading(overlay, frame, theme, figure.scene, subtitle_of(figure));
    if (bars) {
        draw_bars(overlay, figure, layout, style);
    } else {
        draw_lines(overlay, figure, layout, style);
    }
    if (layout.legend_text > 0)
        draw_bench_legend(overlay, layout.legend, layout.left, layout.right, legend,
                          layout.legend_text, theme);
    if (layout.footnote.height > 0) footnote.draw(overlay, layout.footnote);
    return Picture{width, height, 1, theme.background, {}};
}

}  // namespace scb::render
