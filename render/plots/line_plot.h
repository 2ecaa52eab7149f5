#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/overlay/line_stroke.h"
#include "render/overlay/overlay.h"
#include "render/plots/plot_frame.h"

namespace scb::render {

/// One line of a plot.
struct PlotSeries {
    std::string name;
    std::string remark;  ///< behind the name in a legend, such as "mean 21,412"; may be empty
    Rgba8 color;
    LineStroke stroke = LineStroke::solid;
    std::vector<double> x;  ///< ascending
    /// One for each x (surplus elements of either are not drawn). The line has a gap at a value
    /// that is NaN or infinite; a value between two gaps is a dot.
    std::vector<double> y;
};

/// The scale of y. `automatic` is logarithmic if one series would otherwise press the others to the
/// floor: if the largest value is more than 20 times the median of all positive values, and none is
/// negative.
enum class PlotScale { automatic, linear, log10 };

/// How lines are identified: by names at the right ends of the lines, by a row of names and remarks
/// below the plot, or elsewhere. Names are at the lines only if each fits, whole and next to its
/// own line's end. Else no line has a name, since a displaced name would point at the wrong line.
/// So there should be a legend elsewhere, too.
enum class PlotLegend { none, at_lines, below };

/// Values over an axis, several series in one plot.
struct LinePlot {
    std::string title;
    std::string x_label;
    std::string y_label;             ///< ", log scale" is added for such a scale
    std::vector<PlotSeries> series;  ///< later ones over earlier ones
    std::vector<PlotRange> ranges;
    PlotScale scale = PlotScale::automatic;
    PlotLegend legend = PlotLegend::at_lines;
    bool whole_x = false;                ///< x counts something: marks at whole numbers only
    bool from_zero = true;               ///< a linear scale includes 0
    std::string empty_text = "no data";  ///< shown if there is no value to draw
};

/// The scale of the drawn plot: `linear` or `log10`.
PlotScale chosen_scale(const LinePlot& plot);

/// Draws the plot inside the rectangle. On a logarithmic scale, values of 0 lie on a floor of their
/// own, marked "0", and negative values are gaps. Series may have any number of points (see
/// thinned). Returns the rectangle of the data; it is empty, and nothing is drawn, if there is too
/// little room.
PixelRect draw_line_plot(Overlay& overlay, const PixelRect& rect, const LinePlot& plot,
                         const FigureStyle& style);

/// The points of a line (pixels, from left to right) without invisible ones: among consecutive
/// points in one column of pixels, the first, the highest, the lowest and the last stay, in their
/// order. So no peak is lost.
std::vector<ScreenPosition> thinned(std::span<const ScreenPosition> points);

}  // namespace scb::render
