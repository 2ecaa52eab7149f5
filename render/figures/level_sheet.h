#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/level_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::render {

/// One cell of a sheet.
struct LevelSheetCell {
    std::string caption;  ///< above the cell
    std::vector<LevelBody> bodies;
    int level = 0;
    Camera camera;  ///< for a view of the layout
};

/// The layout of a sheet. If there are many cells, they shrink and more are side by side, so that a
/// sheet can always be drawn.
struct LevelSheetLayout : SheetGrid {
    int view_height = 0, detail_size = 0;
};
/// `aspect`: the desired width / height of the views.
LevelSheetLayout level_sheet_layout(std::size_t volumes, std::size_t levels, bool with_detail,
                                    double aspect = 4.0 / 3);

/// Levels side by side, one row of cells for each volume, wrapped if there are many. Below each
/// view is the histogram of its lengths. Among cells with one camera, the first has a scale bar.
struct LevelSheet {
    LevelSheetLayout layout;
    std::string title;
    std::string subtitle;
    std::string note;  ///< the meaning of the numbers; beside the scale, or below the keys
    std::vector<std::vector<LevelSheetCell>>
        rows;  ///< one for each volume, or one for all; with equal lengths
    LevelStyle style;
    Vec3 center = Vec3::Zero();
    std::optional<Detail> detail;
};

/// The levels from this one on share a view that shows all of them. Each level above has its own
/// view, since its large volumes, such as the ball about a flat body, would make the others small.
inline constexpr int first_shared_level = 3;

Picture compose(const LevelSheet& sheet, int samples, Overlay& overlay);

}  // namespace scb::render
