#include "render/figures/frame_sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/figure_layout.h"

namespace scb::render {
namespace {

// In narrower views, neither subject nor caption would be recognizable.
constexpr int narrowest_view = 100;

// As long as views need not be very small for it, a sheet has at most 20 million pixels, so that it
// loads quickly.
constexpr int small_view = 160;
constexpr double roomy_pixels = 20e6;

// Room for a heading wider than a few cells.
constexpr int least_width = 36;  // units

// Title and a line or two of keys, or a scale.
int heading_height(int unit) { return sheet_margin + title_size(unit) + 5 * unit; }

FrameSheetLayout layout_of(int cells, int columns, int view_width, const PixelRect& view) {
    FrameSheetLayout layout{sheet_grid(cells, columns, view_width), 0};
    layout.view_height = std::max(1, static_cast<int>(std::lround(view_width / aspect_of(view))));
    layout.width = std::max(layout.width, least_width * layout.unit);
    layout.height = heading_height(layout.unit) + layout.bands * layout.cell_height();
    return layout;
}

int most_columns(int view_width) {
    return (largest_sheet_side - sheet_margin) / (view_width + sheet_margin);
}

}  // namespace

int FrameSheetLayout::cell_height() const { return view_height + 4 * unit; }

int FrameSheetLayout::view_y() const { return unit * 11 / 4; }

std::optional<FrameSheetLayout> frame_sheet_layout(std::size_t cells, const PixelRect& view) {
    if (cells == 0 || cells > most_frame_cells(view)) return std::nullopt;
    const int count = static_cast<int>(cells);
    const int few = std::min(count, 5);
    for (int width = std::min(roomy_view_width(few), view.width); width > narrowest_view;
         width -= 20)
        for (int columns = few; columns <= std::min(count, most_columns(width)); ++columns) {
            const FrameSheetLayout layout = layout_of(count, columns, width, view);
            const bool wide = 4 * layout.height <= 3 * layout.width || columns == count;
            if (!wide || !fits(layout)) continue;
            if (width <= small_view || 1.0 * layout.width * layout.height <= roomy_pixels)
                return layout;
            break;
        }
    const int width = std::min(narrowest_view, view.width);
    return layout_of(count, most_columns(width), width, view);
}

std::size_t most_frame_cells(const PixelRect& view) {
    const int width = std::min(narrowest_view, view.width);
    const FrameSheetLayout one = layout_of(1, 1, width, view);
    return static_cast<std::size_t>(most_columns(width)) *
           static_cast<std::size_t>((largest_sheet_side - heading_height(one.unit)) /
                                    one.cell_height());
}

}  // namespace scb::render
