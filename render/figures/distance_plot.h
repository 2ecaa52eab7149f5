#pragma once

#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/plots/plot_frame.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

/// The distances of two bodies, frame by frame.
struct DistanceLine {
    std::string name;
    std::vector<double> frames, distances;  ///< NaN where nothing was found
};

/// Distances over frames.
struct DistancePlot {
    std::string title, subtitle;
    std::vector<DistanceLine> lines;
    std::vector<PlotRange> ranges;  ///< frames in contact
    const Theme* theme = &light_theme;
};

/// Composes the plot; all is in the overlay.
Picture compose(const DistancePlot& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
