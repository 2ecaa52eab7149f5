#pragma once

#include <string>
#include <vector>

#include "render/figures/bench_figure.h"
#include "render/overlay/line_stroke.h"

namespace scb::render {

/// How a series looks in plots and legend. No two of a figure look alike: those of one kind of
/// hierarchy have shades of its color, and other strokes.
struct SeriesLook {
    Rgba8 color;
    LineStroke stroke = LineStroke::solid;
};

/// One for each series.
std::vector<SeriesLook> looks_of(const BenchFigure& figure);

/// How a series is called next to its line: as short as its look allows.
std::string series_label(const BenchFigure& figure, std::size_t row);

struct LegendColumn {
    std::string heading;
    std::vector<std::string> values = {};  ///< one for each row
    bool of_time = false;                  ///< stands under the plot of times, where it can
    int rank = 0;  ///< where there is no room for all, those of the highest rank go first
};

struct LegendRow {
    std::string name;
    std::string warning;  ///< behind the name; empty where nothing is wrong
    SeriesLook look;
    bool strong = false;
};

/// The table below the plots: which line is whose, and the means over the frames.
struct BenchLegend {
    std::vector<LegendRow> rows;
    std::vector<LegendColumn> columns;
    bool blocks = false;  ///< colors as blocks, for bars; else samples of the lines
};

/// Times are compared to those of the first slab cut balls, where others are there to compare.
/// Where a series has fewer pairs in some frame than another one has, its row says that it misses
/// pairs (no hierarchy finds any that are none), and all rows say how many they have.
BenchLegend bench_legend(const BenchFigure& figure);

/// How high the table is with text of that size.
int bench_legend_height(const BenchLegend& legend, int text_size);

/// Draws the table into the rectangle, with text of that size, or smaller where it is not wide
/// enough. `left` and `right` are the plots of counts and times above, whose columns stand under
/// them where they can.
void draw_bench_legend(Overlay& overlay, const PixelRect& rect, const PixelRect& left,
                       const PixelRect& right, BenchLegend legend, int text_size,
                       const Theme& theme);

}  // namespace scb::render
