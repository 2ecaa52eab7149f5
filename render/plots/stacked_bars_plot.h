#pragma once

#include <string>
#include <vector>

#include "render/overlay/scales.h"

namespace scb::render {

/// Vertical bars of parts, one for each of a sequence of numbers (of frames, of levels).
struct StackedBarsPlot {
    std::string title;          ///< above, bold; may be empty
    std::string y_label;        ///< the meaning of the amounts
    std::string x_label;        ///< the meaning of the numbers
    std::vector<int> numbers;   ///< ascending
    std::vector<Rgba8> colors;  ///< colors of the parts, from the bottom of a bar to its top
    std::vector<std::vector<double>> amounts;  ///< per number, per part
    double least_top = 0;  ///< the least upper end of the axis: equal for plots to compare
};

/// The mean of each part over all bars.
std::vector<double> mean_amounts(const StackedBarsPlot& plot);

/// The height of the highest bar.
double highest_bar(const StackedBarsPlot& plot);

/// Draws the plot inside the rectangle: one place for each bar, for any numbers. If there are more
/// bars than pixels, a drawn bar is the mean of the bars at its place. Returns the rectangle of the
/// bars; it is empty, and nothing is drawn, if there is too little room.
PixelRect draw_stacked_bars_plot(Overlay& overlay, const PixelRect& rect,
                                 const StackedBarsPlot& plot, const FigureStyle& style);

}  // namespace scb::render
