#include "render/figures/comparison_figure.h"

#include <algorithm>

#include "render/draw/image_operations.h"

namespace scb::render {
namespace {

constexpr int line_height(int unit) { return unit * 5 / 4; }

/// From the caption at the top of `cell` to its panel at the bottom.
ComparisonLayout::Side lay_out_side(const PixelRect& cell, int unit, ComparisonRows rows) {
    const int numbers = rows.numbers * line_height(unit) + unit / 2,
              legend = rows.legend * line_height(unit) + unit / 2;
    // Narrower columns cut the texts of the legend, which is better than no legend.
    const bool beside =
        cell.width >= 29 * unit || numbers + legend > (cell.height - unit * 3 / 2) * 3 / 5;
    const int wanted = beside ? std::max(numbers, legend) : numbers + legend;
    ComparisonLayout::Side side;
    side.caption = {cell.x, cell.y, cell.width, unit * 3 / 2};
    const int top = cell.y + side.caption.height,
              below = std::min(wanted, (cell.height - side.caption.height) * 3 / 5);
    side.view = {cell.x, top, cell.width, std::max(1, cell.y + cell.height - below - top)};
    const int y = side.view.y + side.view.height + unit / 2, end = cell.y + cell.height;
    if (beside) {
        const int width = std::min(13 * unit, cell.width * 2 / 5), gap = 3 * unit / 2;
        side.numbers = {cell.x, y, width, end - y};
        side.legend = {cell.x + width + gap, y, std::min(18 * unit, cell.width - width - gap),
                       end - y};
    } else {
        side.numbers = {cell.x, y, cell.width, std::min(numbers, end - y)};
        const int below_numbers = std::min(y + numbers, end);
        side.legend = {cell.x, below_numbers, cell.width, end - below_numbers};
    }
    return side;
}

}  // namespace

ComparisonLayout comparison_layout(int width, int height, ComparisonRows rows) {
    const FigureLayout whole = figure_layout(width, height);
    const int unit = whole.unit, margin = whole.heading.x;
    const int top = whole.heading.y + whole.heading.height;
    const PixelRect all = {margin, top, width - 2 * margin, height - margin - top};
    ComparisonLayout layout;
    layout.unit = unit;
    layout.heading = whole.heading;
    PixelRect cell = all;
    if (whole.portrait)
        cell.height = (all.height - unit) / 2;
    else
        cell.width = (all.width - 2 * unit) / 2;
    layout.sides[0] = lay_out_side(cell, unit, rows);
    if (whole.portrait)
        cell.y += all.height - cell.height;
    else
        cell.x += all.width - cell.width;
    layout.sides[1] = lay_out_side(cell, unit, rows);
    return layout;
}

std::size_t outline_differences(std::array<ComparedView, 2>& views, std::uint32_t first_id,
                                const Theme& theme) {
    std::vector<std::uint32_t> ids = differing_ids(views[0].pane, views[1].pane);
    std::erase_if(ids, [first_id](std::uint32_t id) { return id < first_id; });
    for (ComparedView& view : views) view.pane.outline = {ids, theme.text, theme.background, 2};
    return ids.size();
}

Picture compose(ComparisonFigure figure, const ComparisonLayout& layout, int width, int height,
                int samples, Overlay& overlay) {
    const Theme& theme = *figure.theme;
    const int unit = layout.unit;
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    FigureLayout heading;
    heading.unit = unit;
    heading.heading = layout.heading;
    draw_heading(overlay, heading, theme, figure.title, figure.subtitle);
    const TextStyle caption{unit, FontWeight::bold, theme.text};
    for (std::size_t i = 0; i < 2; ++i) {
        ComparedView& view = figure.views[i];
        const ComparisonLayout::Side& side = layout.sides[i];
        overlay.rectangle({side.caption.x, side.caption.y, side.caption.width, 1}, theme.border);
        overlay.text(side.caption.x, side.caption.y + unit / 4,
                     fitted_text(overlay, view.caption, caption, side.caption.width), caption);
        draw_remark(overlay, side.view, view.remark, theme, unit);
        if (i == 0)
            draw_scale_bar(overlay, side.view, view.pane.camera, figure.center, theme, unit);
        draw_side_panel(overlay, side.numbers, theme, unit, view.numbers);
        draw_side_panel(overlay, side.legend, theme, unit, view.legend);
        view.pane.viewport = side.view;
        picture.panes.push_back(std::move(view.pane));
    }
    return picture;
}

}  // namespace scb::render
