#pragma once

#include "render/overlay/overlay.h"

namespace scb::render {

/// The layout of sheets: cells of equal size side by side below a heading, wrapped into bands if
/// there are many. The caller, which knows the height of a cell, computes the height.
struct SheetGrid {
    int width = 0, height = 0;
    int unit = 0;                ///< size of body text
    int columns = 0, bands = 0;  ///< cells in a row; rows after wrapping
    int view_width = 0;          ///< of the view in a cell

    /// The left end of a column.
    int x(int column) const;
};

inline constexpr int sheet_margin = 24;

/// A size that every renderer here can draw, even with four samples.
inline constexpr int largest_sheet_side = 8000;

/// A grid of `count` cells, at most `most_columns` side by side; bands are evenly filled.
SheetGrid sheet_grid(int count, int most_columns, int view_width);

/// The width of a view if there is room for all, by the number of columns.
int roomy_view_width(int columns);

bool fits(const SheetGrid& grid);

}  // namespace scb::render
