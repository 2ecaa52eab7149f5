#include "render/stages_figure.h"

#include <algorithm>
#include <cmath>

#include "render/figure_layout.h"
#include "render/plot_frame.h"
#include "render/side_panel.h"

namespace scb {
namespace {

/// A bar: the frames from `begin` to below `end`, their mean counts per group.
struct Bar {
    std::vector<double> amounts;
    double sum = 0;
};

std::vector<Bar> bars_of(const StagesFigure& figure, std::size_t most) {
    const std::size_t frames = figure.frames.size(), count = std::min(frames, most);
    std::vector<Bar> bars;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = i * frames / count, end = (i + 1) * frames / count;
        Bar& bar = bars.emplace_back();
        for (const EndingGroup& group : figure.groups) {
            std::uint64_t sum = 0;
            for (std::size_t f = begin; f < end; ++f) sum += count_of(group, figure.counts[f]);
            bar.amounts.push_back(static_cast<double>(sum) / static_cast<double>(end - begin));
            bar.sum += bar.amounts.back();
        }
    }
    return bars;
}

/// One place for each frame, whatever their numbers; round numbers are marked where there are some,
/// else frames at even steps.
PlotAxis frames_axis(const std::vector<int>& frames, int most_ticks) {
    PlotAxis axis;
    axis.low = 0;
    axis.high = static_cast<double>(frames.size());
    const auto mark = [&](std::size_t i) {
        axis.ticks.push_back({static_cast<double>(i) + 0.5, std::to_string(frames[i])});
    };
    for (const AxisTick& tick :
         linear_axis(frames.front(), frames.back(), most_ticks, AxisEnds::data, true).ticks) {
        const auto at = std::find(frames.begin(), frames.end(), static_cast<int>(tick.value));
        if (at != frames.end()) mark(static_cast<std::size_t>(at - frames.begin()));
    }
    if (axis.ticks.size() >= 2) return axis;
    axis.ticks.clear();
    const std::size_t step = (frames.size() + static_cast<std::size_t>(most_ticks) - 1) /
                             static_cast<std::size_t>(most_ticks);
    for (std::size_t i = 0; i < frames.size(); i += step) mark(i);
    return axis;
}

std::string mean_text(double mean) {
    return mean >= 100 ? count_text(static_cast<std::uint64_t>(std::llround(mean)))
                       : number_text(mean);
}

std::vector<PanelItem> panel_of(const StagesFigure& figure) {
    const std::vector<Bar> bars = bars_of(figure, 1);
    std::vector<PanelItem> items = {PanelRow{"frames", {count_text(figure.frames.size())}},
                                    PanelHeading{"paths that ended, mean per frame"}};
    for (std::size_t g = 0; g < figure.groups.size(); ++g) {
        const double mean = bars[0].amounts[g];
        if (mean == 0 && figure.groups[g].endings.front() == Ending::left_over) continue;
        items.emplace_back(PanelLegendRow{figure.groups[g].color,
                                          std::string(figure.groups[g].label), mean_text(mean),
                                          share_text(mean, bars[0].sum)});
    }
    items.emplace_back(PanelRow{"all", {mean_text(bars[0].sum)}, {}, true});
    return items;
}

}  // namespace

double most_paths(const StagesFigure& figure) {
    double most = 0;
    for (const Bar& bar : bars_of(figure, figure.frames.size())) most = std::max(most, bar.sum);
    return most;
}

Picture compose(const StagesFigure& figure, int width, int height, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    const FigureStyle style{theme, layout.unit};
    const Picture picture{width, height, 1, theme.background, {}};
    overlay.begin();
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    if (figure.frames.empty()) return picture;
    draw_side_panel(overlay, layout.panel, theme, layout.unit, panel_of(figure));

    const double highest = std::max(figure.least_top, most_paths(figure));
    PlotFrame frame;
    frame.y_label = "paths that ended";
    frame.x_label = "frame";
    frame.x = frames_axis(figure.frames, most_x_ticks(layout.view, style));
    frame.y = linear_axis(0, std::max(highest, 1.0), most_y_ticks(layout.view, style),
                          AxisEnds::ticks, true);
    const PixelRect area = draw_plot_frame(overlay, layout.view, frame, style);
    if (area.width <= 0) return picture;
    const std::vector<Bar> bars = bars_of(figure, static_cast<std::size_t>(area.width));
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto edge = [&](std::size_t k) {
            return area.x +
                   static_cast<int>(k * static_cast<std::size_t>(area.width) / bars.size());
        };
        const int left = edge(i), gap = edge(i + 1) - left >= 4 ? 1 : 0;
        std::vector<BarPart> parts;
        for (std::size_t g = 0; g < figure.groups.size(); ++g)
            parts.push_back({figure.groups[g].color, bars[i].amounts[g]});
        draw_stacked_bar(overlay, {left, area.y, edge(i + 1) - left - gap, area.height}, parts,
                         frame.y.high);
    }
    return picture;
}

}  // namespace scb
