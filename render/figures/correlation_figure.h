#pragma once

#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/picture.h"

namespace scb::render {

/// The correlation of one measure with a cost.
struct CorrelationRow {
    std::string name;
    std::vector<double> of_scene;  ///< rank correlations, -1 to 1; NaN: none
    double mean = 0;
};

struct CorrelationPlot {
    std::string title;  ///< the cost
    std::vector<CorrelationRow> rows;
};

/// Rank correlations of measures with costs: a row per measure, a dot per scene, a bar and a number
/// for the mean. The plots lie side by side, or above each other if the picture is taller than
/// wide; both have the same rows.
struct CorrelationFigure {
    std::string title, subtitle;
    std::vector<CorrelationPlot> plots;
    std::string footnote;  ///< small, wrapped; left out if there is no room
    const Theme* theme = &light_theme;
};

/// Composes the figure; all is in the overlay.
Picture compose(const CorrelationFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
