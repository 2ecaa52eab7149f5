#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/renderer.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/overlay.h"
#include "render/overlay/side_panel.h"
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

/// One picture of a sequence.
struct FrameSheetCell {
    std::string caption;               ///< in bold, above the view
    std::string value;                 ///< the number that matters most
    std::vector<std::string> details;  ///< as many as fit
    std::string scale_end;             ///< shown if the pictures' scales differ
    Image view;                        ///< with the size of the layout's views
};

/// A contact sheet of the pictures of a sequence.
struct FrameSheet {
    FrameSheetLayout layout;
    const Theme* theme = &light_theme;
    std::string title, subtitle;
    std::vector<PanelKey> keys;       ///< what colors mean in any of the pictures
    std::optional<PanelScale> scale;  ///< instead of keys
    bool scales_differ = false;
    std::vector<FrameSheetCell> cells;
};

/// Adds the legend of a picture of the sequence, from its panel: the keys that are new, or the
/// scale.
void add_legend(FrameSheet& sheet, const std::vector<PanelItem>& panel);

/// The label at the upper end of the panel's scale; empty if there is none.
std::string scale_end(const std::vector<PanelItem>& panel);

/// Draws the sheet, strip by strip, as a sheet can be many times as large as a picture.
Image draw(const FrameSheet& sheet, Renderer& renderer, Overlay& overlay);

}  // namespace scb::render
