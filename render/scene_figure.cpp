#include "render/scene_figure.h"

namespace scb {

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    draw_side_panel(overlay, layout.panel, theme, layout.unit, figure.panel);
    draw_scale_bar(overlay, layout.view, figure.pane.camera, figure.center, theme, layout.unit);
    if (!figure.remark.empty()) {
        const TextStyle style{layout.unit, FontWeight::bold, theme.accent};
        overlay.text(layout.view.x, layout.view.y,
                     fitted_text(overlay, figure.remark, style, layout.view.width), style);
    }
    figure.pane.viewport = layout.view;
    picture.panes.push_back(std::move(figure.pane));
    return picture;
}

}  // namespace scb
