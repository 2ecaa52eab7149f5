#include <algorithm>

#include "render/level_figure.h"
#include "render/side_panel.h"

namespace scb {
namespace {

constexpr int most_columns = 5;
constexpr int margin = 24;

// Title and keys.
constexpr int heading_height(int unit) { return margin + title_size(unit) + 9 * unit / 2; }

}  // namespace

LevelSheetLayout level_sheet_layout(std::size_t volumes, std::size_t levels, bool with_detail) {
    LevelSheetLayout layout;
    layout.unit = 20;
    const int count = static_cast<int>(levels);
    layout.bands = (count + most_columns - 1) / most_columns;
    layout.columns = (count + layout.bands - 1) / layout.bands;
    layout.view_width = layout.columns <= 2 ? 620 : layout.columns <= 3 ? 520 : 440;
    layout.view_height = layout.view_width * (with_detail ? 5 : 6) / 8;
    layout.detail_size = with_detail ? layout.view_width * 9 / 20 : 0;
    const int cell_height = layout.view_height + layout.detail_size + 4 * layout.unit;
    layout.width = margin + layout.columns * (layout.view_width + margin);
    layout.height =
        heading_height(layout.unit) + layout.bands * static_cast<int>(volumes) * cell_height;
    return layout;
}

Picture compose(const LevelSheet& sheet, int samples, Overlay& overlay) {
    const std::size_t levels = sheet.rows.front().size();
    const LevelSheetLayout layout =
        level_sheet_layout(sheet.rows.size(), levels, sheet.detail.has_value());
    const Theme& theme = *sheet.style.theme;
    const int unit = layout.unit;
    Picture picture{layout.width, layout.height, samples, theme.background, {}};
    overlay.begin();

    FigureLayout frame;
    frame.unit = unit;
    frame.heading = {margin, margin, layout.width - 2 * margin, title_size(unit)};
    draw_heading(overlay, frame, theme, sheet.title, sheet.subtitle);

    // Keys in one line under the heading: bodies by color, or the scale.
    const int key_y = margin + title_size(unit) + unit / 2;
    if (const std::optional<PanelScale> scale = legend_of(sheet.style.colors)) {
        draw_side_panel(overlay, {margin, key_y, 18 * unit, 4 * unit}, theme, unit, {*scale});
    } else {
        int x = margin;
        const auto& bodies = sheet.rows.front().front().bodies;
        for (std::size_t b = 0; b < bodies.size() && x < layout.width / 2; ++b) {
            const std::string text =
                "body " + bodies[b].name + ", " + count_text(bodies[b].triangles) + " triangles";
            const TextStyle style{unit, FontWeight::regular, theme.text};
            const int width = unit * 5 / 4 + overlay.measure(text, style).width + 2 * unit;
            draw_side_panel(overlay, {x, key_y, width, 2 * unit}, theme, unit,
                            {PanelKey{category_color(b), text}});
            x += width;
        }
    }

    const int first_y = heading_height(unit);
    const int cell_height = layout.view_height + layout.detail_size + 4 * unit;
    for (std::size_t r = 0; r < sheet.rows.size(); ++r)
        for (std::size_t c = 0; c < levels; ++c) {
            const LevelSheetCell& cell = sheet.rows[r][c];
            const int band = static_cast<int>(c) / layout.columns,
                      column = static_cast<int>(c) % layout.columns;
            const int x = margin + column * (layout.view_width + margin);
            const int y =
                first_y +
                (band * static_cast<int>(sheet.rows.size()) + static_cast<int>(r)) * cell_height;
            const LevelNumbers numbers = level_numbers(cell.bodies, cell.level);

            overlay.rectangle({x, y - unit / 4, layout.view_width, 1}, theme.border);
            const TextStyle bold{unit, FontWeight::bold, theme.text};
            overlay.text(x, y, cell.caption, bold);
            std::string counts;
            for (const CoverStatistics& s : numbers.bodies)
                counts += (counts.empty() ? "" : " + ") + count_text(s.volumes);
            if (numbers.bodies.size() > 3) counts = count_text(numbers.all.volumes);
            const TextStyle right{unit, FontWeight::regular, theme.text, Align::right};
            overlay.text(x + layout.view_width, y,
                         counts + (counts == "1" ? " volume" : " volumes"), right);
            const TextStyle faint{small_size(unit), FontWeight::regular, theme.faint_text};
            overlay.text(x, y + unit * 5 / 4,
                         "mean d " + number_text(numbers.all.mean_diameter) + ", mean τ " +
                             number_text(numbers.all.mean_thickness) + ", Σ volume " +
                             number_text(numbers.all.volume),
                         faint);

            const PixelRect view{x, y + unit * 5 / 2, layout.view_width, layout.view_height};
            picture.panes.push_back(
                level_pane(view, sheet.camera, cell.bodies, cell.level, sheet.style));
            if (!sheet.detail) {
                if (c == 0) draw_scale_bar(overlay, view, sheet.camera, sheet.center, theme, unit);
                continue;
            }
            const PixelRect square{x + (layout.view_width - layout.detail_size) / 2,
                                   view.y + view.height, layout.detail_size, layout.detail_size};
            picture.panes.push_back(
                level_pane(square, sheet.detail->camera, cell.bodies, cell.level, sheet.style));
            overlay.frame(square, theme.accent, 2);
            if (const auto marker =
                    marker_of(view, sheet.camera, sheet.detail->center, sheet.detail->radius)) {
                overlay.frame(*marker, theme.accent, 2);
            }
            overlay.text(square.x + square.width + unit / 2,
                         square.y + square.height - small_size(unit) * 5 / 4,
                         number_text(2 * sheet.detail->radius) + " wide", faint);
            if (c == 0) draw_scale_bar(overlay, view, sheet.camera, sheet.center, theme, unit);
        }
    return picture;
}

}  // namespace scb
