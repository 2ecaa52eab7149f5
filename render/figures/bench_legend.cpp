#include "render/figures/bench_legend.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/figure_words.h"
#include "render/overlay/figure_layout.h"

namespace scb::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::string unknown = "–";

std::string count_text_of(double mean) {
    if (!std::isfinite(mean)) return unknown;
    return mean >= 100 ? count_text(static_cast<std::uint64_t>(std::llround(mean)))
                       : number_text(mean);
}

// At most two decimals, as in the text table, and three digits.
std::string ratio_text(const std::optional<double>& ratio) {
    if (!ratio) return unknown;
    if (*ratio < 0.005) return "<0.01";
    if (*ratio < 99.95) return format("%.*f", *ratio >= 9.995 ? 1 : 2, *ratio);
    const std::string text = format("%.2e", *ratio);
    const CLocale with_points;
    return number_text(std::strtod(text.c_str(), nullptr));
}

// The number of series of the same kind before a row, and the number of all of them.
std::pair<std::size_t, std::size_t> place_in_kind(const BenchFigure& figure, std::size_t row) {
    std::size_t before = 0, all = 0;
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
        if (figure.series[i].kind != figure.series[row].kind) continue;
        before += i < row;
        ++all;
    }
    return {before, all};
}

/// The most pairs that any series found, per frame.
std::map<int, double> most_pairs(const BenchFigure& figure) {
    std::map<int, double> most;
    for (const BenchSeries& series : figure.series)
        for (std::size_t i = 0; i < std::min(series.frames.size(), series.pairs.size()); ++i)
            if (std::isfinite(series.pairs[i])) {
                double& known = most.try_emplace(series.frames[i], series.pairs[i]).first->second;
                known = std::max(known, series.pairs[i]);
            }
    return most;
}

bool misses_pairs(const BenchSeries& series, const std::map<int, double>& most) {
    for (std::size_t i = 0; i < std::min(series.frames.size(), series.pairs.size()); ++i)
        if (std::isfinite(series.pairs[i]) && series.pairs[i] < most.at(series.frames[i]))
            return true;
    return false;
}

/// A table with the positions of its columns.
struct TablePainter {
    Overlay& overlay;
    const BenchLegend& legend;
    const Theme& theme;
    int size;
    int names = 0;            // width of the first column
    std::vector<int> widths;  // widths of the others
    std::vector<int> rights;  // ends of their texts

    TablePainter(Overlay& target, const BenchLegend& table, const Theme& look, int text_size)
        : overlay(target), legend(table), theme(look), size(text_size) {
        names = start() + overlay.measure("hierarchy", faint()).width;
        for (const LegendRow& row : legend.rows) {
            int width = start() + overlay.measure(row.name, name(row)).width;
            if (!row.warning.empty())
                width += size / 2 + overlay.measure(row.warning, warning()).width;
            names = std::max(names, width);
        }
        for (const LegendColumn& column : legend.columns) {
            int width = overlay.measure(column.heading, faint()).width;
            for (const std::string& value : column.values)
                width = std::max(width, overlay.measure(value, strong(true)).width);
            widths.push_back(width);
        }
        rights.resize(widths.size());
    }

    TextStyle faint() const { return {size, FontWeight::regular, theme.faint_text}; }
    TextStyle warning() const { return {size, FontWeight::bold, theme.warning}; }
    TextStyle strong(bool is_strong) const {
        return {size, is_strong ? FontWeight::bold : FontWeight::regular, theme.text};
    }
    TextStyle name(const LegendRow& row) const { return strong(row.strong); }
    FigureStyle style() const { return {theme, size}; }
    int sample() const { return legend.blocks ? size : line_sample_width(style()); }
    int start() const { return sample() + size / 2; }
    int row_height() const { return size * 5 / 4; }

    // The columns from `begin` on up to `end`, with the same gaps between them.
    bool spread(std::size_t begin, std::size_t end, int from, int to) {
        if (begin == end) return true;
        int free = to - from;
        for (std::size_t i = begin; i < end; ++i) free -= widths[i];
        const int count = static_cast<int>(end - begin);
        if (free < count * size * 3 / 4) return false;
        for (int i = 0, x = from; i < count; ++i) {
            const std::size_t column = begin + static_cast<std::size_t>(i);
            x += widths[column];
            rights[column] = x + free * (i + 1) / count;
        }
        return true;
    }

    bool place(const PixelRect& rect, const PixelRect& left, const PixelRect& right) {
        const auto of_time = std::find_if(legend.columns.begin(), legend.columns.end(),
                                          [](const LegendColumn& c) { return c.of_time; });
        const auto split = static_cast<std::size_t>(of_time - legend.columns.begin());
        const bool beside = right.x >= left.x + left.width;
        if (beside && spread(0, split, rect.x + names, left.x + left.width) &&
            spread(split, widths.size(), right.x, right.x + right.width))
            return true;
        return spread(0, widths.size(), rect.x + names, rect.x + rect.width);
    }

    void draw_row(const PixelRect& rect, std::size_t i, int y) const {
        const LegendRow& row = legend.rows[i];
        if (!row.warning.empty())
            overlay.rectangle({rect.x, y - size / 8 + 1, rect.width, row_height() - 1},
                              mix(theme.background, theme.warning, 0.12));
        if (legend.blocks)
            overlay.rectangle({rect.x, y + size / 8, sample(), size * 3 / 4}, row.look.color);
        else
            draw_line_sample(overlay, rect.x, y + size / 2, sample(), row.look.color,
                             row.look.stroke, style());
        int x = rect.x + start();
        const std::string shown =
            fitted_text(overlay, row.name, name(row), rect.x + std::min(names, rect.width) - x);
        overlay.text(x, y, shown, name(row));
        x += overlay.measure(shown, name(row)).width + size / 2;
        if (!row.warning.empty() &&
            x + overlay.measure(row.warning, warning()).width <= rect.x + rect.width)
            overlay.text(x, y, row.warning, warning());
        for (std::size_t c = 0; c < legend.columns.size(); ++c) {
            TextStyle text = strong(row.strong);
            text.align = Align::right;
            overlay.text(rights[c], y, legend.columns[c].values[i], text);
        }
    }

    void draw(const PixelRect& rect) const {
        TextStyle heading = faint();
        const int indent = rect.width > start() ? start() : 0;
        overlay.text(rect.x + indent, rect.y,
                     fitted_text(overlay, "hierarchy", heading, rect.width - indent), heading);
        heading.align = Align::right;
        for (std::size_t c = 0; c < legend.columns.size(); ++c)
            overlay.text(rights[c], rect.y, legend.columns[c].heading, heading);
        for (std::size_t i = 0; i < legend.rows.size(); ++i) {
            const int y = rect.y + static_cast<int>(i + 1) * row_height();
            overlay.rectangle({rect.x, y - size / 8, rect.width, 1}, theme.border);
            draw_row(rect, i, y);
        }
    }
};

}  // namespace

std::vector<SeriesLook> looks_of(const BenchFigure& figure) {
    std::vector<SeriesLook> looks;
    for (std::size_t row = 0; row < figure.series.size(); ++row) {
        const VolumeKind kind = figure.series[row].kind;
        const auto [i, count] = place_in_kind(figure, row);
        // The line of the second kind of ball often hides under the first one's.
        const std::size_t first = kind == VolumeKind::ritter ? 1 : 0;
        looks.push_back(
            {shade_of(hierarchy_color(kind), i, count, *figure.theme), stroke_of_line(first + i)});
    }
    return looks;
}

std::string series_label(const BenchFigure& figure, std::size_t row) {
    const BenchSeries& series = figure.series[row];
    return place_in_kind(figure, row).second == 1 ? std::string(volume_title(series.kind))
                                                  : series.name;
}

BenchLegend bench_legend(const BenchFigure& figure) {
    const auto scb = std::find_if(figure.series.begin(), figure.series.end(),
                                  [](const BenchSeries& s) { return s.kind == VolumeKind::scb; });
    const bool compares = scb != figure.series.end() && figure.series.size() > 1;
    const std::vector<SeriesLook> looks = looks_of(figure);
    const std::map<int, double> most = most_pairs(figure);
    BenchLegend legend;
    // One frame has no mean.
    const std::string prefix = frames_of(figure).size() > 1 ? "mean " : "";
    LegendColumn n_v{prefix + "N_v"}, n_p{prefix + "N_p", {}, false, 2},
        pairs{prefix + "pairs", {}, false, 1};
    LegendColumn ms{prefix + "ms", {}, true}, all{"time / SCB", {}, true},
        part{"in shaded frames", {}, true, 3};
    bool misses = false;
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
        const BenchSeries& series = figure.series[i];
        const bool warns = misses_pairs(series, most);
        misses = misses || warns;
        legend.rows.push_back({series.name, warns ? "misses pairs" : "", looks[i],
                               scb != figure.series.end() && &series == &*scb});
        n_v.values.push_back(count_text_of(mean(series.n_v)));
        n_p.values.push_back(count_text_of(mean(series.n_p)));
        pairs.values.push_back(count_text_of(mean(series.pairs)));
        const double time = mean(series.ms);
        ms.values.push_back(std::isfinite(time) ? number_text(time) : unknown);
        if (!compares) continue;
        all.values.push_back(ratio_text(time_over_scb(*scb, series, -infinity, infinity)));
        if (!figure.ranges.empty())
            part.values.push_back(ratio_text(
                time_over_scb(*scb, series, figure.ranges[0].from, figure.ranges[0].to)));
    }
    legend.columns = {n_v, n_p};
    if (misses) legend.columns.push_back(pairs);
    legend.columns.push_back(ms);
    if (compares) legend.columns.push_back(all);
    // The first slab cut balls have a ratio if any frame is in the range.
    if (std::any_of(part.values.begin(), part.values.end(),
                    [](const std::string& value) { return value != unknown; }))
        legend.columns.push_back(part);
    return legend;
}

int bench_legend_height(const BenchLegend& legend, int text_size) {
    if (legend.rows.empty()) return 0;
    return static_cast<int>(legend.rows.size() + 1) * (text_size * 5 / 4) + text_size / 4;
}

void draw_bench_legend(Overlay& overlay, const PixelRect& rect, const PixelRect& left,
                       const PixelRect& right, BenchLegend legend, int text_size,
                       const Theme& theme) {
    const int least = std::min(text_size, std::max(10, text_size * 3 / 4));
    for (;;) {
        // Smaller text first, then fewer columns.
        for (int size = text_size; size >= least; --size) {
            TablePainter table(overlay, legend, theme, size);
            if (table.place(rect, left, right)) return table.draw(rect);
        }
        if (legend.columns.empty()) break;
        const auto last =
            std::max_element(legend.columns.begin(), legend.columns.end(),
                             [](const auto& a, const auto& b) { return a.rank <= b.rank; });
        legend.columns.erase(last);
    }
}

}  // namespace scb::render
