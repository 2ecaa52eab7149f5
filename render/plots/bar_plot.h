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
    double value = 0;    ///< none is drawn where it is negative or not finite
    std::string number;  ///< the value for a reader
    std::optional<std::pair<double, double>> range = {};  ///< within which it is: a whisker
    bool marked = false;                                  ///< its row is shaded and its name bold
    bool apart = false;                                   ///< a line sets it apart from those above
};

/// Values that have no axis but their names.
struct BarPlot {
    std::string title;                   ///< above, bold
    std::string label;                   ///< below the title: what the values are, with their unit
    std::vector<PlotBar> bars;           ///< top down
    std::string empty_text = "no data";  ///< where there is no value to draw
};

/// Draws the plot into the rectangle and nothing outside of it. Bars begin at 0. Returns where they
/// are, which is empty where the rectangle is too small for them; then nothing is drawn.
PixelRect draw_bar_plot(Overlay& overlay, const PixelRect& rect, const BarPlot& plot,
                        const FigureStyle& style);

}  // namespace scb::render
