#pragma once

#include <cstddef>
#include <optional>

#include "render/overlay/sheet_grid.h"
#include "render/view/picture.h"

namespace scb::render {

/// The layout of a sheet of views that are already drawn, each below its captions.
struct FrameSheetLayout : SheetGrid {
    int view_height = 0;

    int cell_height() const;
    /// The y at which the view begins in a cell.
    int view_y() const;
};

/// The layout for `cells` cells of a view of this size. Views are shrunk, never enlarged: the more
/// cells, the smaller. Nothing if they would be too small to see, see most_frame_cells.
std::optional<FrameSheetLayout> frame_sheet_layout(std::size_t cells, const PixelRect& view);
std::size_t most_frame_cells(const PixelRect& view);

}  // namespace scb::render
