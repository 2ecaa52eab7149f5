#include "render/figures/distance_plot.h"

#include "render/overlay/figure_layout.h"
#include "render/plots/line_plot.h"

namespace scb::render {

Picture compose(const DistancePlot& figure, int width, int height, Overlay& overlay) {
    const FigureLayout frame = figure_layout(width, height);
    const int margin = frame.heading.x,
              top = frame.heading.y + frame.heading.height + frame.unit / 2;
    overlay.begin();
    draw_heading(overlay, frame, *figure.theme, figure.title, figure.subtitle);
    LinePlot plot;
    plot.y_label = "distance, in units of the mesh";
    plot.x_label = "frame";
    plot.ranges = figure.ranges;
    plot.whole_x = true;
    plot.scale = PlotScale::linear;
    plot.legend = figure.lines.size() > 1 ? PlotLegend::below : PlotLegend::none;
    for (std::size_t i = 0; i < figure.lines.size(); ++i) {
        const DistanceLine& line = figure.lines[i];
        plot.series.push_back(
            {line.name, "", category_color(i), LineStroke::solid, line.frames, line.distances});
    }
    draw_line_plot(overlay, {margin, top, width - 2 * margin, height - margin - top}, plot,
                   {*figure.theme, frame.unit});
    return Picture{width, height, 1, figure.theme->background, {}};
}

}  // namespace scb::render
