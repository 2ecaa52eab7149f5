#pragma once

#include <string>
#include <vector>

#include "render/figure_layout.h"
#include "render/side_panel.h"

namespace scb {

/// A picture with one view of the scene: heading, view, panel of numbers, scale bar.
struct SceneFigure {
    std::string title;
    std::string subtitle;
    Pane pane;                   ///< its viewport is set by compose()
    Vec3 center = Vec3::Zero();  ///< where the scale bar holds
    std::vector<PanelItem> panel;
    std::string remark;  ///< in the view, at the top: what a reader would otherwise miss
    const Theme* theme = &light_theme;
};

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay);

}  // namespace scb
