#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/plots/plot_frame.h"

namespace scb::render {

/// Tests of volumes by the depth of their pair and by the lower bound of their distance.
struct BoundsPlot {
    /// One test.
    struct Test {
        std::uint32_t depth = 0;  ///< the depths of both nodes added
        double bound = 0;
        std::uint8_t group = 0;  ///< index into `colors`
    };
    std::vector<Test> tests;
    std::vector<Rgba8> colors;  ///< of groups; the first group is at the left of a bar
    double answer = 0;          ///< a line across; none if it is not finite
    std::string answer_label;   ///< at the line
};

/// Draws the tests as bars: a column for each depth, and rows of bounds. A bar is as long as the
/// square root of its number of tests, at most as wide as its column, and its parts are the shares
/// of the groups. The scale of bounds is logarithmic if the largest bound is more than 4 times the
/// answer. Bounds below a thousandth of the answer are then in the lowest row.
void draw_bounds_plot(Overlay& overlay, const PixelRect& rect, const BoundsPlot& plot,
                      const FigureStyle& style);

/// Bars of one row and one column of depths: the number of tests of each group.
struct BoundsCell {
    std::size_t column = 0;
    /// From the answer down: 0 begins at the answer, and has no bound above it. Above are negative
    /// rows. Without an answer, row 0 begins at the top.
    int row = 0;
    std::vector<std::uint32_t> counts;
};

/// The cells that have tests, by column and row. `rows`: how many rows are as tall as the axis.
/// `depths_per_column`: at least 1.
std::vector<BoundsCell> bounds_cells(const BoundsPlot& plot, const PlotAxis& y, double rows,
                                     std::uint32_t depths_per_column);

/// The axis of the bounds.
PlotAxis bounds_axis(const BoundsPlot& plot, int most_ticks);

}  // namespace scb::render
