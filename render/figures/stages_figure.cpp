#include "render/figures/stages_figure.h"

#include <cmath>
#include <numeric>

#include "render/overlay/figure_layout.h"
#include "render/overlay/side_panel.h"
#include "render/plots/stacked_bars_plot.h"

namespace scb::render {
namespace {

StackedBarsPlot plot_of(const StagesFigure& figure) {
    StackedBarsPlot plot;
    plot.y_label = "paths that ended";
    plot.x_label = "frame";
    plot.numbers = figure.frames;
    for (const EndingGroup& group : figure.groups) plot.colors.push_back(group.color);
    for (const EndingCounts& counts : figure.counts) {
        std::vector<double>& bar = plot.amounts.emplace_back();
        for (const EndingGroup& group : figure.groups)
            bar.push_back(static_cast<double>(count_of(group, counts)));
    }
    plot.least_top = figure.least_top;
    return plot;
}

std::string mean_text(double mean) {
    return mean >= 100 ? count_text(static_cast<std::uint64_t>(std::llround(mean)))
                       : number_text(mean);
}

std::vector<PanelItem> panel_of(const StagesFigure& figure) {
    const std::vector<double> means = mean_amounts(plot_of(figure));
    const double all = std::accumulate(means.begin(), means.end(), 0.0);
    std::vector<PanelItem> items = {PanelRow{"frames", {count_text(figure.frames.size())}},
                                    PanelHeading{"paths that ended, mean per frame"}};
    for (std::size_t g = 0; g < figure.groups.size(); ++g) {
        const EndingGroup& group = figure.groups[g];
        if (means[g] == 0 && group.endings.front() == Stage::left_over) continue;
        items.emplace_back(PanelLegendRow{group.color, std::string(group.label),
                                          mean_text(means[g]), share_text(means[g], all)});
    }
    items.emplace_back(PanelRow{"all", {mean_text(all)}, {}, true});
    return items;
}

}  // namespace

double most_paths(const StagesFigure& figure) { return highest_bar(plot_of(figure)); }

Picture compose(const StagesFigure& figure, int width, int height, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    overlay.begin();
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    if (!figure.frames.empty()) {
        draw_side_panel(overlay, layout.panel, theme, layout.unit, panel_of(figure));
        draw_stacked_bars_plot(overlay, layout.view, plot_of(figure), {theme, layout.unit});
    }
    return {width, height, 1, theme.background, {}};
}

}  // namespace scb::render
