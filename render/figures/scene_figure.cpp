#include "render/figures/scene_figure.h"

#include <algorithm>
#include <utility>

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

/// Sets the pane into the view, with its squares; with a panel also scale bar and remark.
Pane pane_in_view(SceneFigure& figure, const PixelRect& view, int unit, Overlay& overlay) {
    const Theme& theme = *figure.theme;
    if (figure.with_panel)
        draw_scale_bar(overlay, view, figure.pane.camera, figure.center, theme, unit);
    for (const SceneMarker& marker : figure.markers) {
        // Large enough to be found.
        const double least =
            unit / 2.0 / pixels_per_unit(figure.pane.camera, marker.center, view.height);
        if (const auto square =
                marker_of(view, figure.pane.camera, marker.center, std::max(marker.radius, least)))
            overlay.frame(*square, theme.accent, std::max(2, unit / 8));
    }
    if (figure.with_panel) draw_remark(overlay, view, figure.remark, theme, unit);
    figure.pane.viewport = view;
    return std::move(figure.pane);
}

}  // namespace

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height, figure.with_panel);
    const Theme& theme = *figure.theme;
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    if (figure.with_panel) {
        draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
        const int below = draw_side_panel(overlay, layout.panel, theme, layout.unit, figure.panel);
        draw_chart(overlay, layout, below, theme, figure.chart);
    }
    picture.panes.push_back(pane_in_view(figure, layout.view, layout.unit, overlay));
    return picture;
}

Picture compose_view(SceneFigure figure, int width, int height, int unit, int samples,
                     Overlay& overlay) {
    Picture picture{width, height, samples, figure.theme->background, {}};
    overlay.begin();
    picture.panes.push_back(pane_in_view(figure, {0, 0, width, height}, unit, overlay));
    return picture;
}

}  // namespace scb::render
