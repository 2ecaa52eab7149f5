#include "render/bench_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "render/figure_layout.h"
#include "render/line_plot.h"
#include "render/side_panel.h"

namespace scb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const char* short_name(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::scb:
            return "SCB";
        case VolumeKind::ball:
            return "ball";
        case VolumeKind::ritter:
            return "Ritter";
        case VolumeKind::obb:
            break;
    }
    return "OBB";
}

// A second series of the same kind, and the second kind of ball, whose line often hides under the
// first one's.
LineStroke stroke_of(const BenchFigure& figure, std::size_t row) {
    const VolumeKind kind = figure.series[row].kind;
    for (std::size_t i = 0; i < row; ++i)
        if (figure.series[i].kind == kind) return LineStroke::dashed;
    return kind == VolumeKind::ritter ? LineStroke::dashed : LineStroke::solid;
}

// The SCB's line lies over the others, and a dashed line over a solid one.
int layer_of(const BenchFigure& figure, std::size_t row) {
    return (figure.series[row].kind == VolumeKind::scb ? 2 : 0) +
           (stroke_of(figure, row) == LineStroke::dashed ? 1 : 0);
}

LinePlot plot_of(const BenchFigure& figure, std::vector<double> BenchSeries::*values) {
    LinePlot plot;
    plot.x_label = "frame";
    plot.ranges = figure.ranges;
    plot.whole_x = true;
    for (int layer = 0; layer < 4; ++layer)
        for (std::size_t row = 0; row < figure.series.size(); ++row) {
            if (layer_of(figure, row) != layer) continue;
            const BenchSeries& series = figure.series[row];
            const bool alone = std::count_if(figure.series.begin(), figure.series.end(),
                                             [&](const BenchSeries& other) {
                                                 return other.kind == series.kind;
                                             }) == 1;
            PlotSeries line{alone ? short_name(series.kind) : series.name,
                            "",
                            hierarchy_color(series.kind),
                            stroke_of(figure, row),
                            {series.frames.begin(), series.frames.end()},
                            series.*values};
            // Frames that are not known are gaps, and both plots have the same frames.
            line.y.resize(line.x.size(), std::numeric_limits<double>::quiet_NaN());
            plot.series.push_back(std::move(line));
        }
    return plot;
}

/// The table below the plots.
struct Column {
    std::string heading;
    int right = 0;                         ///< where its texts end
    int width = 0;                         ///< what they have room for
    std::vector<std::string> values = {};  ///< one for each series
};

std::string count_or_dash(const std::optional<double>& mean) {
    if (!mean) return "–";
    return *mean >= 100 ? count_text(static_cast<std::uint64_t>(std::llround(*mean)))
                        : number_text(*mean);
}

std::vector<Column> columns_of(const BenchFigure& figure) {
    const auto scb = std::find_if(figure.series.begin(), figure.series.end(),
                                  [](const BenchSeries& s) { return s.kind == VolumeKind::scb; });
    const bool compares = scb != figure.series.end() && figure.series.size() > 1;
    Column n_v{"mean N_v"}, n_p{"mean N_p"}, ms{"mean ms"}, all{"SCB's speed-up"},
        part{"in shaded frames"};
    for (const BenchSeries& series : figure.series) {
        n_v.values.push_back(count_or_dash(mean_of(series.n_v)));
        n_p.values.push_back(count_or_dash(mean_of(series.n_p)));
        const std::optional<double> mean = mean_of(series.ms);
        ms.values.push_back(mean ? number_text(*mean) : "–");
        if (!compares) continue;
        const auto factor = [&](double from, double to) -> std::string {
            if (&series == &*scb) return "";
            const std::optional<double> ratio = speed_up(*scb, series, from, to);
            return ratio ? number_text(*ratio) + "×" : "–";
        };
        all.values.push_back(factor(-infinity, infinity));
        if (!figure.ranges.empty())
            part.values.push_back(factor(figure.ranges[0].from, figure.ranges[0].to));
    }
    std::vector<Column> columns = {n_v, n_p, ms};
    if (compares) columns.push_back(all);
    if (!part.values.empty()) columns.push_back(part);
    return columns;
}

std::string subtitle_of(const BenchFigure& figure) {
    std::string text;
    for (const std::uint64_t count : figure.triangles)
        text += (text.empty() ? "" : " + ") + count_text(count);
    if (!text.empty()) text += " triangles";
    std::set<int> frames;
    for (const BenchSeries& series : figure.series)
        frames.insert(series.frames.begin(), series.frames.end());
    if (frames.empty()) return text;
    if (!text.empty()) text += ", ";
    const int first = *frames.begin(), last = *frames.rbegin();
    if (first == last) return text + "frame " + std::to_string(first);
    const auto count = static_cast<std::int64_t>(frames.size());
    if (count <= std::int64_t{last} - first) text += std::to_string(count) + " of ";
    return text + "frames " + std::to_string(first) + " to " + std::to_string(last);
}

struct BenchLayout {
    FigureLayout frame;
    PixelRect left, right;  ///< the plots
    PixelRect table, footnote;
};

BenchLayout layout_of(int width, int height, int rows, int footnote_height) {
    BenchLayout layout;
    layout.frame = figure_layout(width, height);
    const int unit = layout.frame.unit, margin = layout.frame.heading.x;
    const int inside = width - 2 * margin, gutter = 2 * unit;
    const int top = layout.frame.heading.y + layout.frame.heading.height + unit / 2;
    int bottom = height - margin;
    const int least = (layout.frame.portrait ? 18 : 9) * unit;
    int table_height = rows > 0 ? (rows + 1) * unit * 5 / 4 + unit / 2 : 0;
    if (bottom - footnote_height - table_height - top < least) footnote_height = 0;
    if (bottom - table_height - top < least) table_height = 0;
    layout.footnote = {margin, bottom - footnote_height, inside, footnote_height};
    bottom -= footnote_height;
    layout.table = {margin, bottom - table_height, inside, table_height};
    bottom -= table_height + (table_height > 0 ? unit / 2 : 0);

    if (layout.frame.portrait) {
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

// Columns of counts stand under the plot of counts, those of times under that of times.
void place(std::vector<Column>& columns, const BenchLayout& layout) {
    const int unit = layout.frame.unit, margin = layout.table.x;
    const auto spread = [&](std::size_t begin, std::size_t end, int from, int to) {
        const int count = static_cast<int>(end - begin);
        for (int i = 0; i < count; ++i) {
            Column& column = columns[begin + static_cast<std::size_t>(i)];
            column.right = from + (to - from) * (i + 1) / count;
            column.width = (to - from) / count - unit / 2;
        }
    };
    if (layout.frame.portrait) {
        spread(0, columns.size(), margin + layout.table.width / 4, margin + layout.table.width);
    } else {
        spread(0, 2, margin + layout.left.width * 9 / 20, margin + layout.left.width);
        spread(2, columns.size(), layout.right.x, layout.right.x + layout.right.width);
    }
}

void draw_table(Overlay& overlay, const BenchFigure& figure, const BenchLayout& layout,
                const FigureStyle& style) {
    std::vector<Column> columns = columns_of(figure);
    place(columns, layout);
    const int unit = style.unit, row_height = unit * 5 / 4, sample = 3 * unit / 2;
    const TextStyle faint{unit, FontWeight::regular, style.theme.faint_text};
    const int x = layout.table.x, names = columns[0].right - columns[0].width - x - unit / 2;
    int y = layout.table.y;
    overlay.text(x + sample + unit / 2, y, "hierarchy", faint);
    // Headings and numbers are never cut but set smaller.
    const auto write = [&](const Column& column, const std::string& text, TextStyle look) {
        look.align = Align::right;
        while (look.size > 8 && overlay.measure(text, look).width > column.width) --look.size;
        overlay.text(column.right, y + (unit - look.size) * 4 / 5, text, look);
    };
    for (const Column& column : columns) write(column, column.heading, faint);
    for (std::size_t row = 0; row < figure.series.size(); ++row) {
        y += row_height;
        overlay.rectangle({x, y - unit / 8, layout.table.width, 1}, style.theme.border);
        const BenchSeries& series = figure.series[row];
        const bool subject = series.kind == VolumeKind::scb;
        const TextStyle text{unit, subject ? FontWeight::bold : FontWeight::regular,
                             style.theme.text};
        draw_line_sample(overlay, x, y + unit / 2, sample, hierarchy_color(series.kind),
                         stroke_of(figure, row), style);
        overlay.text(x + sample + unit / 2, y,
                     fitted_text(overlay, series.name, text, names - sample - unit / 2), text);
        for (const Column& column : columns) write(column, column.values[row], text);
    }
}

}  // namespace

std::optional<double> mean_of(const std::vector<double>& values) {
    double sum = 0;
    std::size_t count = 0;
    for (const double value : values)
        if (std::isfinite(value)) sum += value, ++count;
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

std::optional<double> speed_up(const BenchSeries& scb, const BenchSeries& other, double from,
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

Picture compose(const BenchFigure& figure, int width, int height, Overlay& overlay) {
    const Theme& theme = *figure.theme;
    const std::vector<PanelItem> footnote = {PanelNote{figure.footnote}};
    // Written once only to see how many lines it takes.
    overlay.begin();
    const FigureLayout frame = figure_layout(width, height);
    const PixelRect anywhere{0, 0, width - 2 * frame.heading.x, height};
    const int footnote_height = draw_side_panel(overlay, anywhere, theme, frame.unit, footnote);
    const BenchLayout layout =
        layout_of(width, height, static_cast<int>(figure.series.size()), footnote_height);

    overlay.begin();
    const FigureStyle style{theme, frame.unit};
    draw_heading(overlay, layout.frame, theme, figure.scene, subtitle_of(figure));
    LinePlot counts = plot_of(figure, &BenchSeries::n_v);
    counts.title = "Volume pair tests";
    counts.y_label = "N_v per frame";
    LinePlot times = plot_of(figure, &BenchSeries::ms);
    times.title = "Time";
    times.y_label = "ms per frame";
    times.empty_text = "not measured";
    // Read side by side: time follows the counts.
    counts.scale = times.scale = chosen_scale(counts);
    draw_line_plot(overlay, layout.left, counts, style);
    draw_line_plot(overlay, layout.right, times, style);
    if (layout.table.height > 0) draw_table(overlay, figure, layout, style);
    if (layout.footnote.height > 0)
        draw_side_panel(overlay, layout.footnote, theme, style.unit, footnote);
    return Picture{width, height, 1, theme.background, {}};
}

}  // namespace scb
