#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/overlay/scales.h"

namespace scb::render {

/// A horizontal bar, with its name before it and its number behind it.
struct PlotBar {
    std::string name;
    Rgba8 color;
    double value = 0;    ///< no bar is drawn if it is negative or not finite
    std::string number;  ///< the value for a reader
    std::optional<std::pair<double, double>> range = {};  ///< the range of the value: a whisker
    bool marked = false;                                  ///< its row is shaded and its name bold
    bool apart = false;                                   ///< a line separates it from the bars
                                                          ///< above
};

/// Values that have no axis but their names.
struct BarPlot {
    std::string title;                   ///< above, bold
    std::string label;                   ///< below the title: the meaning of the values, with their
                                         ///< unit
    std::vector<PlotBar> bars;           ///< top down
    std::string empty_text = "no data";  ///< shown if there is no value to draw
};

/// Draws the plot inside the rectangle. Bars begin at 0. Returns the rectangle of the bars; it is
/// empty, and nothing is drawn, if there is too little room.
PixelRect draw_bar_plot(Overlay& overlay, const PixelRect& rect, const BarPlot& plot,
                        const FigureStyle& style);

}  // namespace scb::render
