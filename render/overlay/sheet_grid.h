#pragma once

#include "render/overlay/overlay.h"

namespace scb::render {

/// Cells of equal size side by side below a heading, wrapped into bands where there are many: what
/// sheets share. The height is for whoever knows how high a cell is.
struct SheetGrid {
    int width = 0, height = 0;
    int unit = 0;                ///< size of body text
    int columns = 0, bands = 0;  ///< cells in a row; rows of them that wrapping leads to
    int view_width = 0;          ///< of what a cell shows

    /// The left end of a column.
    int x(int column) const;
};

inline constexpr int sheet_margin = 24;

/// What every renderer here can draw, even with four samples.
inline constexpr int largest_sheet_side = 8000;

/// A grid of `count` cells, at most so many side by side; bands are evenly filled.
SheetGrid sheet_grid(int count, int most_columns, int view_width);

/// How wide a view can be where there is room for all, by how many are side by side.
int roomy_view_width(int columns);

bool fits(const SheetGrid& grid);

}  // namespace scb::render
