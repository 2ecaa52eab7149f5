#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/level_figure.h"
#include "render/overlay/sheet_grid.h"

namespace scb::render {

/// One row or column of a sheet: what is compared.
struct LevelSheetCell {
    std::string caption;  ///< above the cell
    std::vector<LevelBody> bodies;
    int level = 0;
    Camera camera;  ///< for a view of the layout
};

/// The pixels of a sheet. Cells shrink, and more stand side by side, where there are many, so that
/// a sheet can always be drawn.
struct LevelSheetLayout : SheetGrid {
    int view_height = 0, detail_size = 0;
};
/// `aspect`: width / height of what the views show, as far as they can have it.
LevelSheetLayout level_sheet_layout(std::size_t volumes, std::size_t levels, bool with_detail,
                                    double aspect = 4.0 / 3);

/// Levels side by side, one row of cells for each volume, wrapped where there are many. Below each
/// view is the histogram of its lengths. A scale bar is in the first of cells that have one camera.
struct LevelSheet {
    LevelSheetLayout layout;
    std::string title;
    std::string subtitle;
    std::string note;  ///< what the numbers are; beside the scale, or below the keys
    std::vector<std::vector<LevelSheetCell>>
        rows;  ///< one for each volume, or one of all; of the same length
    LevelStyle style;
    Vec3 center = Vec3::Zero();
    std::optional<Detail> detail;
};

/// The levels from this one on share a view that holds all of them. Each level above has its own,
/// since its volumes, such as the ball about all of a flat body, would leave little of the view to
/// the others.
inline constexpr int first_shared_level = 3;

Picture compose(const LevelSheet& sheet, int samples, Overlay& overlay);

}  // namespace scb::render
