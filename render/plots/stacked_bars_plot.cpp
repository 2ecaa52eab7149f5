#include "render/plots/stacked_bars_plot.h"

#include <algorithm>
#include <numeric>

#include "render/plots/plot_frame.h"

namespace scb::render {
namespace {

/// At most `most` bars, each the mean of consecutive bars.
std::vector<std::vector<double>> means(const StackedBarsPlot& plot, std::size_t most) {
    const std::size_t all = plot.amounts.size(), count = std::min(all, most);
    std::vector<std::vector<double>> bars;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = i * all / count, end = (i + 1) * all / count;
        std::vector<double>& bar = bars.emplace_back();
        for (std::size_t part = 0; part < plot.colors.size(); ++part) {
            double sum = 0;
            for (std::size_t k = begin; k < end; ++k) sum += plot.amounts[k][part];
            bar.push_back(sum / static_cast<double>(end - begin));
        }
    }
    return bars;
}

bool are_evenly_spaced(const std::vector<int>& numbers) {
    for (std::size_t i = 2; i < numbers.size(); ++i)
        if (numbers[i] - numbers[i - 1] != numbers[1] - numbers[0]) return false;
    return true;
}

/// One place for each number, for any numbers. If the numbers have even steps and some are round,
/// the round ones are marked, as readers expect. Else every n-th number is marked.
PlotAxis numbers_axis(const std::vector<int>& numbers, int most_ticks) {
    PlotAxis axis;
    axis.low = 0;
    axis.high = static_cast<double>(numbers.size());
    const auto mark = [&](std::size_t i) {
        axis.ticks.push_back({static_cast<double>(i) + 0.5, std::to_string(numbers[i])});
    };
    if (are_evenly_spaced(numbers))
        for (const AxisTick& tick :
             linear_axis(numbers.front(), numbers.back(), most_ticks, AxisEnds::data, true).ticks) {
            const auto at = std::find(numbers.begin(), numbers.end(), static_cast<int>(tick.value));
            if (at != numbers.end()) mark(static_cast<std::size_t>(at - numbers.begin()));
        }
    if (axis.ticks.size() >= 2) return axis;
    axis.ticks.clear();
    const std::size_t step = (numbers.size() + static_cast<std::size_t>(most_ticks) - 1) /
                             static_cast<std::size_t>(most_ticks);
    for (std::size_t i = 0; i < numbers.size(); i += step) mark(i);
    return axis;
}

}  // namespace

std::vector<double> mean_amounts(const StackedBarsPlot& plot) {
    return plot.amounts.empty() ? std::vector<double>(plot.colors.size()) : means(plot, 1)[0];
}

double highest_bar(const StackedBarsPlot& plot) {
    double highest = 0;
    for (const std::vector<double>& bar : plot.amounts)
        highest = std::max(highest, std::accumulate(bar.begin(), bar.end(), 0.0));
    return highest;
}

PixelRect draw_stacked_bars_plot(Overlay& overlay, const PixelRect& rect,
                                 const StackedBarsPlot& plot, const FigureStyle& style) {
    if (plot.numbers.empty()) return {rect.x, rect.y, 0, 0};
    PlotFrame frame;
    frame.title = plot.title;
    frame.y_label = plot.y_label;
    frame.x_label = plot.x_label;
    frame.x = numbers_axis(plot.numbers, most_x_ticks(rect, style));
    frame.y = linear_axis(0, std::max({highest_bar(plot), plot.least_top, 1.0}),
                          most_y_ticks(rect, style), AxisEnds::ticks, true);
    const PixelRect area = draw_plot_frame(overlay, rect, frame, style);
    if (area.width <= 0) return area;
    const std::vector<std::vector<double>> bars = means(plot, static_cast<std::size_t>(area.width));
    const auto edge = [&](std::size_t k) {
        return area.x + static_cast<int>(k * static_cast<std::size_t>(area.width) / bars.size());
    };
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const int left = edge(i), gap = edge(i + 1) - left >= 4 ? 1 : 0;
        std::vector<BarPart> parts;
        for (std::size_t part = 0; part < plot.colors.size(); ++part)
            parts.push_back({plot.colors[part], bars[i][part]});
        // The width of few bars is limited: draw_stacked_bar draws a bar that is wider than tall as
        // a horizontal one.
        const int slot = edge(i + 1) - left - gap,
                  width = std::min({slot, 8 * style.unit, std::max(1, area.height - 1)});
        draw_stacked_bar(overlay, {left + (slot - width) / 2, area.y, width, area.height}, parts,
                         frame.y.high);
    }
    return area;
}

}  // namespace scb::render
