#include "render/plots/bounds_plot.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"

namespace scb::render {
namespace {

// Beyond this ratio, a linear scale would hide what is below the answer.
constexpr double most_linear = 4;

std::uint32_t depths_of(const BoundsPlot& plot) {
    std::uint32_t depths = 1;
    for (const BoundsPlot::Test& test : plot.tests) depths = std::max(depths, test.depth + 1);
    return depths;
}

/// Marks of the depths, in the middles of their columns.
PlotAxis depth_axis(std::uint32_t depths, const PixelRect& rect, const FigureStyle& style) {
    PlotAxis axis = linear_axis(0, depths - 1, most_x_ticks(rect, style), AxisEnds::data, true);
    axis.low = -0.5;
    axis.high = depths - 0.5;
    return axis;
}

/// Draws the parts of a bar of this length; each has at least a pixel.
void draw_bar(Overlay& overlay, const PixelRect& bar, const BoundsCell& cell,
              const std::vector<Rgba8>& colors) {
    std::vector<BarPart> parts;
    double sum = 0;
    for (std::size_t i = 0; i < cell.counts.size(); ++i) {
        parts.push_back({colors[i], static_cast<double>(cell.counts[i])});
        sum += cell.counts[i];
    }
    draw_stacked_bar(overlay, bar, parts, sum);
}

std::uint32_t tests_of(const BoundsCell& cell) {
    return std::accumulate(cell.counts.begin(), cell.counts.end(), 0u);
}

/// The answer as a share of the axis, from the top; 0 if it is not finite.
double answer_down(const BoundsPlot& plot, const PlotAxis& y) {
    const double up = std::isfinite(plot.answer) ? axis_position(y, plot.answer) : 1;
    return std::isnan(up) ? 0 : 1 - up;
}

int answer_line(const FigureStyle& style) { return std::max(2, style.unit / 10); }

/// `at`: the top of the line.
void draw_answer(Overlay& overlay, const PixelRect& area, const BoundsPlot& plot, int at,
                 const FigureStyle& style) {
    overlay.rectangle({area.x, at, area.width, answer_line(style)}, style.theme.text);
    const TextStyle text{style.unit, FontWeight::bold, style.theme.text};
    const int left = area.x + style.unit / 2;
    const std::string label =
        fitted_text(overlay, plot.answer_label, text, std::max(0, area.width - style.unit));
    const TextSize size = overlay.measure(label, text);
    // Above the line, or below it at the top. Few tests are at the left.
    const int above = at - size.height - style.unit / 4,
              top = above < area.y ? at + style.unit / 4 : above;
    overlay.rectangle({left - style.unit / 5, top, size.width + 2 * style.unit / 5, size.height},
                      with_opacity(style.theme.background, 0.8));
    overlay.text(left, top, label, text);
}

}  // namespace

PlotAxis bounds_axis(const BoundsPlot& plot, int most_ticks) {
    double most = 0, lowest = HUGE_VAL, least = HUGE_VAL;
    for (const BoundsPlot::Test& test : plot.tests) {
        most = std::max(most, test.bound);
        lowest = std::min(lowest, test.bound);
        if (test.bound > 0) least = std::min(least, test.bound);
    }
    const double answer = std::isfinite(plot.answer) ? plot.answer : 0;
    most = std::max(most, answer);
    if (answer > 0 ? most <= most_linear * answer : !std::isfinite(least))
        return linear_axis(std::min(lowest, most), most, most_ticks, AxisEnds::ticks);
    const double floor = (answer > 0 ? answer : most) / 1000;
    return log_axis(std::max(std::min(least, answer > 0 ? answer : least), floor), most, most_ticks,
                    true);
}

std::vector<BoundsCell> bounds_cells(const BoundsPlot& plot, const PlotAxis& y, double rows,
                                     std::uint32_t depths_per_column) {
    const double answer = answer_down(plot, y);
    const bool has_answer = std::isfinite(plot.answer);
    const int lowest = std::max(0, static_cast<int>(std::ceil((1 - answer) * rows)) - 1);
    std::map<std::pair<std::size_t, int>, BoundsCell> cells;
    for (const BoundsPlot::Test& test : plot.tests) {
        const double down = 1 - axis_position(y, test.bound);
        int row = std::min(static_cast<int>(std::floor((down - answer) * rows)), lowest);
        // Rounding must move no bar across the line of the answer.
        if (has_answer) row = test.bound > plot.answer ? std::min(row, -1) : std::max(row, 0);
        const std::size_t column = test.depth / depths_per_column;
        BoundsCell& cell = cells[{column, row}];
        cell.column = column;
        cell.row = row;
        cell.counts.resize(plot.colors.size());
        ++cell.counts[test.group];
    }
    std::vector<BoundsCell> result;
    for (auto& [place, cell] : cells) result.push_back(std::move(cell));
    return result;
}

void draw_bounds_plot(Overlay& overlay, const PixelRect& rect, const BoundsPlot& plot,
                      const FigureStyle& style) {
    const std::uint32_t depths = depths_of(plot);
    PlotFrame frame;
    frame.y = bounds_axis(plot, most_y_ticks(rect, style));
    frame.x = depth_axis(depths, rect, style);
    frame.y_label = std::string("lower bound of the distance of two volumes") +
                    (frame.y.log10 ? ", log scale" : "");
    frame.x_label = "depth of the pair: depths of A's and of B's node added";
    const PixelRect area = draw_plot_frame(overlay, rect, frame, style);
    if (area.width == 0) return;
    // A row is tall enough to see, a column wide enough for bars of several lengths.
    const int row_height = std::max(3, style.unit / 4);
    const int least_width = std::max(4, style.unit / 2);
    std::uint32_t per_column = 1;
    while (static_cast<double>(area.width) * per_column / depths < least_width &&
           per_column < depths)
        ++per_column;
    const double height = area.height - 1;
    const std::vector<BoundsCell> cells =
        bounds_cells(plot, frame.y, height / row_height, per_column);
    // The line hides no bar, and leaves room for a row below it.
    const int line = std::isfinite(plot.answer) ? answer_line(style) : 0,
              bottom = area.y + area.height;
    const int answer =
        std::min(area.y + static_cast<int>(std::lround(answer_down(plot, frame.y) * height)),
                 bottom - row_height - line);
    const auto top_of = [&](const BoundsCell& cell) {
        const int top = answer + cell.row * row_height + (cell.row < 0 ? 0 : line);
        return std::clamp(top, area.y, bottom - row_height);
    };
    // Volumes that overlap share one row, and would make all other bars short.
    const auto is_lowest = [&](const BoundsCell& cell) {
        return top_of(cell) + row_height >= bottom - 1;
    };
    std::uint32_t most = 1;
    for (const BoundsCell& cell : cells)
        if (!is_lowest(cell)) most = std::max(most, tests_of(cell));
    const double pitch = static_cast<double>(area.width) * per_column / depths;
    for (const BoundsCell& cell : cells) {
        const int left = area.x + static_cast<int>(pitch * static_cast<double>(cell.column));
        const int room = std::max(2, static_cast<int>(pitch) - std::max(1, style.unit / 10));
        const double share = std::sqrt(static_cast<double>(tests_of(cell)) / most);
        const int length = std::clamp(static_cast<int>(std::lround(share * room)), 2, room);
        draw_bar(overlay, {left, top_of(cell), length, row_height - 1}, cell, plot.colors);
    }
    if (std::isfinite(plot.answer)) draw_answer(overlay, area, plot, answer, style);
}

}  // namespace scb::render
