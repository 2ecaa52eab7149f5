#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/overlay/figure_layout.h"
#include "render/overlay/scales.h"
#include "render/overlay/side_panel.h"

namespace scb::render {

/// Stacked bars, one per row from top to bottom, all on one scale. Row i is labelled with i. Rows
/// have the same parts; if there is too little room, a bar is for several rows.
struct PanelChart {
    std::string title;
    std::vector<std::vector<BarPart>> rows;
};

/// A ball in the scene around which a square is drawn, over everything.
struct SceneMarker {
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

/// A short text on a small panel at a point of the scene, over everything.
struct SceneLabel {
    Vec3 at = Vec3::Zero();
    std::string text;
    Rgba8 frame;  ///< of the panel
    /// An end of a line through the point: the label is beside the line, and does not cover it.
    std::optional<Vec3> line_end = std::nullopt;
};

/// A picture with one view of the scene: heading, view, panel of numbers, scale bar.
struct SceneFigure {
    std::string title;
    std::string subtitle;
    Pane pane;                   ///< its viewport is set by compose()
    Vec3 center = Vec3::Zero();  ///< the place for which the scale bar is valid
    std::vector<PanelItem> panel;
    PanelChart chart;  ///< below the panel, if there is room
    /// Below the panel, if there is room and no chart. With a chart, the whole is in a corner of
    /// the view, and a part is left out.
    std::optional<Detail> detail;
    std::vector<SceneMarker> markers;
    /// The first ones first; a label that would cover an earlier one, or that is not in the view,
    /// is left out.
    std::vector<SceneLabel> labels;
    std::string remark;  ///< in the view, at the top: for things that a reader would otherwise miss
    /// False: the view alone, with its markers, and without text.
    bool with_panel = true;
    const Theme* theme = &light_theme;
};

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay);

/// The view alone, as large as the picture, with its markers, and a small view of the whole in a
/// corner if the figure's detail is one; `unit`: the size of its text.
Picture compose_view(SceneFigure figure, int width, int height, int unit, int samples,
                     Overlay& overlay);

}  // namespace scb::render
