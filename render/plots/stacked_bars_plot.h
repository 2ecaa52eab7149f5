#pragma once

#include <string>
#include <vector>

#include "render/overlay/scales.h"

namespace scb::render {

/// Vertical bars of parts, one for each of a sequence of numbers (of frames, of levels).
struct StackedBarsPlot {
    std::string title;          ///< above, bold; may be empty
    std::string y_label;        ///< what the amounts are
    std::string x_label;        ///< what the numbers are
    std::vector<int> numbers;   ///< ascending
    std::vector<Rgba8> colors;  ///< of the parts, from the bottom of a bar to its top
    std::vector<std::vector<double>> amounts;  ///< per number, per part
    double least_top = 0;  ///< the axis reaches this far at least: the same for plots compared
};

/// The mean of each part over all bars.
std::vector<double> mean_amounts(const StackedBarsPlot& plot);

/// The height of the highest bar.
double highest_bar(const StackedBarsPlot& plot);

/// Draws the plot into the rectangle and nothing outside of it: one place for each bar, whatever
/// the numbers. Where there are more of them than pixels, a bar is the mean of those that fall on
/// it. Returns where the bars are, which is empty where the rectangle is too small for them; then
/// nothing is drawn.
PixelRect draw_stacked_bars_plot(Overlay& overlay, const PixelRect& rect,
                                 const StackedBarsPlot& plot, const FigureStyle& style);

}  // namespace scb::render
