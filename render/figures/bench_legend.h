#pragma once

#include <string>
#include <vector>

#include "render/figures/bench_figure.h"
#include "render/overlay/line_stroke.h"

namespace scb::render {

/// The look of a series in plots and legend. Each series of a figure has its own look: series of
/// one kind of hierarchy have shades of its color, and different strokes.
struct SeriesLook {
    Rgba8 color;
    LineStroke stroke = LineStroke::solid;
};

/// One for each series.
std::vector<SeriesLook> looks_of(const BenchFigure& figure);

/// The name of a series next to its line: the kind of volume if that is unique, else its whole
/// name.
std::string series_label(const BenchFigure& figure, std::size_t row);

struct LegendColumn {
    std::string heading;
    std::vector<std::string> values = {};  ///< one for each row
    bool of_time = false;                  ///< below the plot of times, if there is room
    int rank = 0;  ///< without room for all, columns of the highest rank are left out first
};

struct LegendRow {
    std::string name;
    std::string warning;  ///< behind the name; empty if nothing is wrong
    SeriesLook look;
    bool strong = false;
};

/// The table below the plots: names of the lines, and the means over the frames.
struct BenchLegend {
    std::vector<LegendRow> rows;
    std::vector<LegendColumn> columns;
    bool blocks = false;  ///< colors as blocks, for bars; else samples of the lines
};

/// If there are several series, times are compared with the first slab cut balls. If a series has
/// fewer pairs in some frame than another one, its row says that it misses pairs (no hierarchy
/// finds false pairs), and all rows have the number of their pairs.
BenchLegend bench_legend(const BenchFigure& figure);

/// The height of the table with text of this size.
int bench_legend_height(const BenchLegend& legend, int text_size);

/// Draws the table into the rectangle, with text of this size, or smaller if the rectangle is too
/// narrow. `left` and `right` are the plots of counts and times above; their columns are below them
/// if there is room.
void draw_bench_legend(Overlay& overlay, const PixelRect& rect, const PixelRect& left,
                       const PixelRect& right, BenchLegend legend, int text_size,
                       const Theme& theme);

}  // namespace scb::render
