#pragma once

#include <string>
#include <vector>

#include "render/overlay/line_stroke.h"
#include "render/plots/plot_frame.h"

namespace scb::render {

/// One line of a plot.
struct PlotSeries {
    std::string name;
    std::string remark;  ///< behind the name in a legend, such as "mean 21,412"; may be empty
    Rgba8 color;
    LineStroke stroke = LineStroke::solid;
    std::vector<double> x;  ///< ascending
    /// One for each x (what one of the two has more than the other is not drawn). Where a value is
    /// NaN or infinite the line has a gap; a value between two gaps is a dot.
    std::vector<double> y;
};

/// How the values of y are spread. `automatic` is logarithmic where one series would otherwise
/// press the others to the floor: where the largest value is more than 20 times the median of all
/// positive ones, and none is negative.
enum class PlotScale { automatic, linear, log10 };

/// How a reader learns which line is whose: from names at the right ends of the lines, from a row
/// of names and remarks below the plot, or from elsewhere. Names stand at the lines only where each
/// can, whole and next to its own line's end; else at none, for a name that was pushed away points
/// at the wrong line. So there should be a legend elsewhere, too.
enum class PlotLegend { none, at_lines, below };

/// Values over an axis, several series in one plot.
struct LinePlot {
    std::string title;
    std::string x_label;
    std::string y_label;             ///< gets ", log scale" added where it is one
    std::vector<PlotSeries> series;  ///< later ones over earlier ones
    std::vector<PlotRange> ranges;
    PlotScale scale = PlotScale::automatic;
    PlotLegend legend = PlotLegend::at_lines;
    bool whole_x = false;                ///< x counts something: marks at whole numbers only
    bool from_zero = true;               ///< a linear scale includes 0
    std::string empty_text = "no data";  ///< where there is no value to draw
};

/// The scale that a plot is drawn with: `linear` or `log10`.
PlotScale chosen_scale(const LinePlot& plot);

/// Draws the plot into the rectangle and nothing outside of it. On a logarithmic scale, values of 0
/// lie on a floor of their own, marked "0", and negative ones are gaps. Series may have any number
/// of points (see thinned). Returns where the data are, which is empty where the rectangle is too
/// small for a plot; then nothing is drawn.
PixelRect draw_line_plot(Overlay& overlay, const PixelRect& rect, const LinePlot& plot,
                         const FigureStyle& style);

}  // namespace scb::render
