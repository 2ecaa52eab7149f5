#include "render/figures/scene_figure.h"

#include <algorithm>

namespace scb::render {
namespace {

// Below the panel's rows, or beside them where the panel is below the view.
void draw_chart(Overlay& overlay, const FigureLayout& layout, int below, const Theme& theme,
                const PanelChart& chart) {
    const auto rows = static_cast<int>(chart.rows.size());
    if (rows == 0) return;
    const int unit = layout.unit, small = small_size(unit);
    PixelRect box = {layout.panel.x, below + unit / 2, layout.panel.width,
                     layout.panel.y + layout.panel.height - below - unit / 2};
    if (layout.portrait) {
        box = layout.panel;
        box.x += layout.panel.width + unit;
        box.width = layout.view.x + layout.view.width - box.x;
    }
    const int row_height = std::min(unit, (box.height - small * 5 / 2) / rows);
    if (row_height < 2 || box.width < 6 * unit) return;
    double full = 0;
    for (const std::vector<BarPart>& row : chart.rows) {
        double sum = 0;
        for (const BarPart& part : row) sum += part.amount;
        full = std::max(full, sum);
    }
    const TextStyle faint{small, FontWeight::regular, theme.faint_text};
    const TextStyle label{small, FontWeight::regular, theme.faint_text, Align::right};
    overlay.text(box.x, box.y, chart.title, faint);
    overlay.text(box.x + box.width, box.y, "to " + count_text(static_cast<std::uint64_t>(full)),
                 label);
    const int labels = small * 5 / 3, top = box.y + small * 3 / 2;
    // As many rows are labelled as there is room for.
    const int step = row_height >= small ? 1 : row_height * 5 >= small ? 5 : 10;
    for (int i = 0; i < rows; ++i) {
        const int y = top + i * row_height, gap = row_height > 3 ? 1 : 0;
        if (i % step == 0)
            overlay.text(box.x + labels - unit / 3, y + (row_height - small) / 2, std::to_string(i),
                         label);
        draw_stacked_bar(overlay, {box.x + labels, y, box.width - labels, row_height - gap},
                         chart.rows[static_cast<std::size_t>(i)], full);
    }
}

void draw_beside(Overlay& overlay, const FigureLayout& layout, const SceneFigure& figure) {
    const Theme& theme = *figure.theme;
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    const int below = draw_side_panel(overlay, layout.panel, theme, layout.unit, figure.panel);
    draw_chart(overlay, layout, below, theme, figure.chart);
    draw_scale_bar(overlay, layout.view, figure.pane.camera, figure.center, theme, layout.unit);
}

}  // namespace

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height, figure.with_panel);
    const Theme& theme = *figure.theme;
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    if (figure.with_panel) draw_beside(overlay, layout, figure);
    for (const SceneMarker& marker : figure.markers) {
        // Large enough to be found.
        const double least = layout.unit / 2.0 /
                             pixels_per_unit(figure.pane.camera, marker.center, layout.view.height);
        if (const auto square = marker_of(layout.view, figure.pane.camera, marker.center,
                                          std::max(marker.radius, least)))
            overlay.frame(*square, theme.accent, std::max(2, layout.unit / 8));
    }
    if (figure.with_panel) draw_remark(overlay, layout.view, figure.remark, theme, layout.unit);
    figure.pane.viewport = layout.view;
    picture.panes.push_back(std::move(figure.pane));
    return picture;
}

}  // namespace scb::render
