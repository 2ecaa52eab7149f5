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

/// All parts of a plot except its data.
struct PlotFrame {
    std::string title;    ///< above, bold; may be empty
    std::string y_label;  ///< above, below the title: the meaning of y, with its unit; may be empty
    std::string x_label;  ///< below; may be empty
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotRange> ranges;
    int right = 0;  ///< free pixels right of the data
};

/// The number of marks for which an axis of a plot in this rectangle has room.
int most_x_ticks(const PixelRect& rect, const FigureStyle& style);
int most_y_ticks(const PixelRect& rect, const FigureStyle& style);

/// The rectangle in which draw_plot_frame puts the data.
PixelRect plot_area(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                    const FigureStyle& style);

/// Draws title, axes, grid and shaded ranges into the rectangle. Returns the rectangle for the
/// data; it is empty (width or height 0), and nothing is drawn, if there is too little room.
PixelRect draw_plot_frame(Overlay& overlay, const PixelRect& rect, const PlotFrame& frame,
                          const FigureStyle& style);

}  // namespace scb::render
