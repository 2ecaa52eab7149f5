#pragma once

#include <string>
#include <vector>

#include "render/overlay/scales.h"
#include "render/plots/plot_axis.h"

namespace scb::render {

/// A part of the x axis that is shaded from top to bottom.
struct PlotRange {
    double from = 0;
    double to = 0;
    std::string label;  ///< above the plot, over the range; may be empty
};

/// Everything of a plot but its data.
struct PlotFrame {
    std::string title;    ///< above, bold; may be empty
    std::string y_label;  ///< above, below the title: what y is, with its unit; may be empty
    std::string x_label;  ///< below; may be empty
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotRange> ranges;
    int right = 0;  ///< pixels right of the data that are left free
};

/// How many marks an axis of a plot in that rectangle has room for.
int most_x_ticks(const PixelRect& rect, const FigureStyle& style);
int most_y_ticks(const PixelRect& rect, const FigureStyle& style);

/// Where draw_plot_frame puts the data.
PixelRect plot_area(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                    const FigureStyle& style);

/// Draws title, axes, grid and shaded ranges into the rectangle. Returns where the data go, which
/// is empty (width or height 0) where the rectangle is too small for a plot; then nothing is drawn.
PixelRect draw_plot_frame(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                          const FigureStyle& style);

}  // namespace scb::render
