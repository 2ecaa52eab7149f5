#include "render/plots/line_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"
#include "render/overlay/line_stroke.h"

namespace scb::render {
namespace {

// Above this ratio, a linear scale would hide most lines in its lowest twentieth.
constexpr double peak_to_median = 20;

bool drawable(double value) { return std::abs(value) <= largest_plot_value; }

/// The range of the drawn values.
struct DataRange {
    double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
    double y_low = x_low, y_high = -x_low;
    double y_low_positive = x_low;
    bool has_zero = false;
    std::vector<double> positive;

    bool empty() const { return x_low > x_high || y_low > y_high; }
};

DataRange range_of(const LinePlot& plot) {
    DataRange range;
    for (const PlotSeries& series : plot.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            const double x = series.x[i], y = series.y[i];
            if (!drawable(x)) continue;
            // Gaps at the ends are part of the picture.
            range.x_low = std::min(range.x_low, x);
            range.x_high = std::max(range.x_high, x);
            if (!drawable(y)) continue;
            range.y_low = std::min(range.y_low, y);
            range.y_high = std::max(range.y_high, y);
            if (y == 0) range.has_zero = true;
            if (y > 0) {
                range.y_low_positive = std::min(range.y_low_positive, y);
                range.positive.push_back(y);
            }
        }
    return range;
}

PlotScale chosen_scale(const LinePlot& plot, const DataRange& range) {
    const bool possible = !range.positive.empty();
    if (plot.scale != PlotScale::automatic) return possible ? plot.scale : PlotScale::linear;
    if (!possible || range.y_low < 0) return PlotScale::linear;
    return range.y_high / peak_to_median > median(range.positive) ? PlotScale::log10
                                                                  : PlotScale::linear;
}

PlotAxis y_axis(const LinePlot& plot, const DataRange& range, int most_ticks) {
    if (chosen_scale(plot, range) == PlotScale::log10)
        return log_axis(range.y_low_positive, range.y_high, most_ticks, range.has_zero);
    double low = range.y_low, high = range.y_high;
    if (plot.from_zero) {
        low = std::min(low, 0.0);
        high = std::max(high, 0.0);
    }
    return linear_axis(low, high, most_ticks, AxisEnds::ticks);
}

/// The pieces of a line between its gaps, in pixels.
std::vector<std::vector<ScreenPosition>> pieces_of(const PlotSeries& series, const PixelRect& area,
                                                   const PlotAxis& x, const PlotAxis& y) {
    std::vector<std::vector<ScreenPosition>> pieces(1);
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const double right = drawable(series.x[i]) ? axis_position(x, series.x[i]) : NAN;
        const double up = drawable(series.y[i]) ? axis_position(y, series.y[i]) : NAN;
        if (std::isnan(right) || std::isnan(up)) {
            if (!pieces.back().empty()) pieces.emplace_back();
            continue;
        }
        // Marks are one pixel wide; the line goes through their middles.
        pieces.back().push_back(
            {area.x + 0.5 + right * (area.width - 1), area.y + 0.5 + (1 - up) * (area.height - 1)});
    }
    if (pieces.back().empty()) pieces.pop_back();
    for (auto& piece : pieces) piece = thinned(piece);
    return pieces;
}

/// A name at the right end of a line.
struct EndLabel {
    const PlotSeries* series;
    ScreenPosition end;  ///< of the line
    int y = 0;           ///< of the name's middle
};

int name_height(const FigureStyle& style) { return small_size(style.unit) * 6 / 5; }

// Moves names apart within the rows from top to bottom, with the least total motion that keeps
// their order.
void spread(std::vector<EndLabel>& labels, int height, int top, int bottom) {
    std::stable_sort(labels.begin(), labels.end(),
                     [](const EndLabel& a, const EndLabel& b) { return a.end.y < b.end.y; });
    // Names that touch move as one block, whose middle is the mean of their ends.
    struct Block {
        double first;  // the desired row of its first name
        int count;
    };
    std::vector<Block> blocks;
    for (const EndLabel& label : labels) {
        blocks.push_back({label.end.y, 1});
        while (blocks.size() > 1) {
            const Block below = blocks.back();
            Block& above = blocks[blocks.size() - 2];
            if (above.first + above.count * height <= below.first) break;
            above.first =
                (above.first * above.count + (below.first - above.count * height) * below.count) /
                (above.count + below.count);
            above.count += below.count;
            blocks.pop_back();
        }
    }
    std::size_t i = 0;
    const int count = static_cast<int>(labels.size());
    for (const Block& block : blocks)
        for (int k = 0; k < block.count; ++k, ++i) {
            const int above = static_cast<int>(i), below = count - 1 - above;
            labels[i].y =
                std::clamp(static_cast<int>(std::lround(block.first)) + k * height,
                           top + height / 2 + above * height, bottom - height / 2 - below * height);
        }
}

TextStyle name_style(const FigureStyle& style) {
    return {small_size(style.unit), FontWeight::medium, style.theme.text};
}

/// The end of the last line, which may be far from the right end: a single point is in the middle.
double last_end(const std::vector<EndLabel>& labels) {
    double right = 0;
    for (const EndLabel& label : labels) right = std::max(right, label.end.x);
    return right;
}

/// The names in their places, or none if a name could not be next to its own line's end.
std::vector<EndLabel> placed_labels(const LinePlot& plot, const PlotFrame& frame,
                                    const PixelRect& area, const FigureStyle& style) {
    std::vector<EndLabel> labels;
    for (const PlotSeries& series : plot.series) {
        if (series.name.empty()) continue;
        const auto pieces = pieces_of(series, area, frame.x, frame.y);
        if (!pieces.empty()) labels.push_back({&series, pieces.back().back()});
    }
    const int height = name_height(style);
    if (static_cast<int>(labels.size()) * height > area.height) return {};
    spread(labels, height, area.y, area.y + area.height);
    const double right = last_end(labels);
    for (const EndLabel& label : labels)
        if (right - label.end.x > style.unit || std::abs(label.y - label.end.y) >= height)
            return {};
    return labels;
}

void draw_end_labels(Overlay& overlay, const std::vector<EndLabel>& labels, const PixelRect& area,
                     const FigureStyle& style) {
    const int small = small_size(style.unit), indent = style.unit;
    const double right = last_end(labels);
    for (const EndLabel& label : labels) {
        const double x = std::round(right) + indent;
        const std::vector<ScreenPosition> leader = {
            {label.end.x + style.unit / 6.0, label.end.y},
            {x - indent * 0.35, label.y + 0.5},
        };
        draw_smooth_line(overlay, leader, with_opacity(label.series->color, 0.7),
                         std::max(1.0, style.unit / 16.0));
        TextStyle text = name_style(style);
        text.color = mix(label.series->color, style.theme.text, 0.35);
        const int left = static_cast<int>(x), top = label.y - small / 2;
        // If names are among the data, no grid line goes through them.
        if (left < area.x + area.width)
            overlay.rectangle(
                {left - 2, top, overlay.measure(label.series->name, text).width + 4, small},
                style.theme.background);
        overlay.text(left, top, label.series->name, text);
    }
}

/// Rows of line samples, names and remarks, wrapped to the width; only measured if `draw` is false.
/// Returns the height.
int legend_rows(Overlay& overlay, const PixelRect& rect, const std::vector<PlotSeries>& series,
                const FigureStyle& style, bool draw) {
    const TextStyle name = name_style(style);
    const TextStyle remark{small_size(style.unit), FontWeight::regular, style.theme.faint_text};
    const int height = style.unit * 5 / 4, sample = line_sample_width(style), gap = style.unit / 2;
    int x = rect.x, y = rect.y + style.unit / 4;
    for (const PlotSeries& s : series) {
        const std::string shown = fitted_text(overlay, s.name, name, rect.width - sample - gap);
        const int name_width = overlay.measure(shown, name).width;
        int width = sample + gap + name_width;
        const int remark_width = overlay.measure(s.remark, remark).width;
        const bool with_remark = !s.remark.empty() && width + gap + remark_width <= rect.width;
        if (with_remark) width += gap + remark_width;
        if (x > rect.x && x + width > rect.x + rect.width) {
            x = rect.x;
            y += height;
        }
        if (draw) {
            draw_line_sample(overlay, x, y + small_size(style.unit) / 2, sample, s.color, s.stroke,
                             style);
            overlay.text(x + sample + gap, y, shown, name);
            if (with_remark) overlay.text(x + sample + 2 * gap + name_width, y, s.remark, remark);
        }
        x += width + style.unit * 3 / 2;
    }
    return series.empty() ? 0 : y + height - rect.y;
}

}  // namespace

PlotScale chosen_scale(const LinePlot& plot) {
    DataRange range = range_of(plot);
    return chosen_scale(plot, range);
}

PixelRect draw_line_plot(Overlay& overlay, const PixelRect& rect, const LinePlot& plot,
                         const FigureStyle& style) {
    DataRange range = range_of(plot);
    PixelRect box = rect;
    int legend_height = 0;
    if (plot.legend == PlotLegend::below) {
        legend_height = legend_rows(overlay, rect, plot.series, style, false);
        box.height -= legend_height;
    }

    PlotFrame frame{plot.title, plot.y_label, plot.x_label, {}, {}, plot.ranges, 0};
    if (!range.empty()) {
        frame.x = linear_axis(range.x_low, range.x_high, most_x_ticks(box, style), AxisEnds::data,
                              plot.whole_x);
        frame.y = y_axis(plot, range, most_y_ticks(box, style));
        if (frame.y.log10) frame.y_label += frame.y_label.empty() ? "log scale" : ", log scale";
    } else {
        frame.ranges.clear();
    }
    // A dot is three strokes wide.
    const int least_right = 2 * stroke_width(style);
    std::vector<EndLabel> labels;
    if (plot.legend == PlotLegend::at_lines && !range.empty()) {
        int names = 0;
        for (const PlotSeries& series : plot.series)
            names = std::max(
                names, style.unit + 1 + overlay.measure(series.name, name_style(style)).width);
        frame.right = std::max(least_right, names);
        // Names are not cut, but must leave two thirds of the width for the data.
        if (names <= rect.width / 3)
            labels = placed_labels(plot, frame, plot_area(overlay, box, frame, style), style);
    }
    if (labels.empty()) frame.right = least_right;

    const PixelRect area = draw_plot_frame(overlay, box, frame, style);
    if (area.width == 0) return area;
    for (const PlotSeries& series : plot.series)
        for (const auto& piece : pieces_of(series, area, frame.x, frame.y))
            draw_stroke(overlay, piece, series.color, series.stroke, stroke_width(style));
    if (range.empty()) {
        const TextStyle text{style.unit, FontWeight::regular, style.theme.faint_text,
                             Align::center};
        overlay.text(area.x + area.width / 2, area.y + (area.height - style.unit) / 2,
                     fitted_text(overlay, plot.empty_text, text, area.width), text);
    }
    draw_end_labels(overlay, labels, area, style);
    if (plot.legend == PlotLegend::below)
        legend_rows(overlay, {rect.x, box.y + box.height, rect.width, legend_height}, plot.series,
                    style, true);
    return area;
}

std::vector<ScreenPosition> thinned(std::span<const ScreenPosition> points) {
    std::vector<ScreenPosition> result;
    std::size_t begin = 0;
    while (begin < points.size()) {
        const double column = std::floor(points[begin].x);
        std::size_t low = begin, high = begin, end = begin;
        for (; end < points.size() && std::floor(points[end].x) == column; ++end) {
            if (points[end].y < points[low].y) low = end;
            if (points[end].y > points[high].y) high = end;
        }
        // A NaN position is in no column.
        if (end == begin) {
            ++begin;
            continue;
        }
        std::array kept = {begin, low, high, end - 1};
        std::sort(kept.begin(), kept.end());
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (i == 0 || kept[i] != kept[i - 1]) result.push_back(points[kept[i]]);
        begin = end;
    }
    return result;
}

}  // namespace scb::render
