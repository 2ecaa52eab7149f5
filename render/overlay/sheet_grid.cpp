#include "render/overlay/sheet_grid.h"

#include <algorithm>

namespace scb::render {

int SheetGrid::x(int column) const { return sheet_margin + column * (view_width + sheet_margin); }

SheetGrid sheet_grid(int count, int most_columns, int view_width) {
    SheetGrid grid;
    grid.bands = (count + most_columns - 1) / most_columns;
    grid.columns = (count + grid.bands - 1) / grid.bands;
    grid.view_width = view_width;
    grid.unit = std::clamp(view_width / 20, 14, 28);
    grid.width = grid.x(grid.columns);
    return grid;
}

int roomy_view_width(int columns) { return columns <= 2 ? 620 : columns <= 3 ? 520 : 440; }

bool fits(const SheetGrid& grid) {
    return grid.width <= largest_sheet_side && grid.height <= largest_sheet_side;
}

}  // namespace scb::render
