#include "render/plots/icicle_plot.h"

#include <algorithm>

#include "core/analysis/traversal_tree.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"
#include "render/plots/icicle.h"

namespace scb::render {
namespace {

// Rectangles at least so wide end with a thin line, and rows at least so high with one of
// background. Across a row background means that there are no tests.
constexpr int least_parted_width = 5, least_parted_height = 5;
constexpr int least_icicle_text = 10;

}  // namespace

Rgba8 divided_color(const Theme& theme) { return mix(theme.background, theme.text, 0.1); }

PixelRect draw_icicle(Overlay& overlay, const PixelRect& rect, const Events& events,
                      const TraversalTree& tree, const std::vector<EndingGroup>& groups,
                      const FigureStyle& style) {
    const Theme& theme = style.theme;
    const int unit = style.unit, small = small_size(unit);
    const TextStyle label{small, FontWeight::regular, theme.faint_text, Align::right};
    const int left = overlay.measure("00", label).width + unit / 3;
    if (rect.width <= left || rect.height < 1) return {rect.x, rect.y, 0, 0};
    const Icicle icicle = render::icicle(events, tree, groups, rect.width - left, rect.height);
    if (icicle.rows == 0) return {rect.x, rect.y, 0, 0};
    const std::vector<std::uint32_t> sizes = subtree_sizes(tree);

    const int row_height = std::min(rect.height / icicle.rows, 2 * unit);
    const int row_gap = row_height >= least_parted_height ? 1 : 0;
    const int text = std::min(small, row_height - row_gap - 2);
    for (const IcicleRun& run : icicle.runs) {
        PixelRect box{rect.x + left + run.begin, rect.y + run.row * row_height, run.end - run.begin,
                      row_height - row_gap};
        const bool divided = run.group == IcicleRun::divided;
        overlay.rectangle(box, divided ? divided_color(theme) : groups[run.group].color);
        if (box.width >= least_parted_width && run.test != IcicleRun::several)
            overlay.rectangle({--box.width + box.x, box.y, 1, box.height}, theme.border);
        if (!divided || run.test == IcicleRun::several || text < least_icicle_text) continue;
        const TextStyle number{text, FontWeight::regular, theme.text, Align::center};
        const std::string count = count_text(sizes[run.test]);
        if (overlay.measure(count, number).width + unit / 2 <= box.width)
            overlay.text(box.x + box.width / 2, box.y + (box.height - text) / 2, count, number);
    }

    int stride = 1;
    for (const int factor : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
        stride = factor;
        if (row_height * factor >= small) break;
    }
    for (int row = 0; row < icicle.rows; row += stride)
        overlay.text(rect.x + left - unit / 3,
                     rect.y + row * row_height + (row_height - row_gap - small) / 2,
                     std::to_string(row * icicle.depths_per_row), label);
    return {rect.x, rect.y, rect.width, icicle.rows * row_height};
}

}  // namespace scb::render
