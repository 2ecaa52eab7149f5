#include "render/figures/level_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/model/level_statistics.h"
#include "render/figures/item_count.h"
#include "render/overlay/side_panel.h"

namespace scb::render {
namespace {

constexpr int most_level_columns = 5;

// Title and keys.
constexpr int level_heading_height(int unit) {
    return sheet_margin + title_size(unit) + 9 * unit / 2;
}

int histogram_height(const LevelSheetLayout& layout) {
    return length_histogram_height({light_theme, layout.unit});
}

bool same_view(const Camera& one, const Camera& other) {
    return one.position == other.position && one.view_height == other.view_height;
}

int cell_height(const LevelSheetLayout& layout) {
    return layout.view_height + layout.detail_size + histogram_height(layout) + 5 * layout.unit;
}

}  // namespace

LevelSheetLayout level_sheet_layout(std::size_t volumes, std::size_t levels, bool with_detail,
                                    double aspect) {
    const int count = static_cast<int>(levels), rows = static_cast<int>(volumes);
    LevelSheetLayout layout;
    const auto lay_out = [&](int columns, int view_width) {
        static_cast<SheetGrid&>(layout) = sheet_grid(count, columns, view_width);
        layout.view_height =
            static_cast<int>(std::lround(view_width / std::clamp(aspect, 1.0, 2.5)));
        layout.detail_size = with_detail ? view_width * 9 / 20 : 0;
        layout.height =
            level_heading_height(layout.unit) + layout.bands * rows * cell_height(layout);
        return fits(layout);
    };
    const int columns = std::min(count, most_level_columns);
    const int roomy = roomy_view_width(columns);
    // As tall as twice its width is tall enough.
    for (int wider = most_level_columns; wider <= 2 * most_level_columns; ++wider)
        if (lay_out(std::min(count, wider), roomy) && layout.height <= 2 * layout.width)
            return layout;
    for (int view_width = roomy; view_width >= 160; view_width -= 20)
        for (int wider = most_level_columns; wider <= count + most_level_columns; wider += 2)
            if (lay_out(std::min(count, wider), view_width)) return layout;
    return layout;
}

Picture compose(const LevelSheet& sheet, int samples, Overlay& overlay) {
    const std::size_t levels = sheet.rows.front().size();
    const LevelSheetLayout& layout = sheet.layout;
    const Theme& theme = *sheet.style.theme;
    const int unit = layout.unit;
    Picture picture{layout.width, layout.height, samples, theme.background, {}};
    overlay.begin();

    FigureLayout frame;
    frame.unit = unit;
    frame.heading = {sheet_margin, sheet_margin, layout.width - 2 * sheet_margin, title_size(unit)};
    draw_heading(overlay, frame, theme, sheet.title, sheet.subtitle);

    // Keys in one line under the heading: bodies by color, or the scale.
    const int key_y = sheet_margin + title_size(unit) + unit / 2;
    if (const std::optional<PanelScale> scale = legend_of(sheet.style.colors)) {
        draw_side_panel(overlay, {sheet_margin, key_y, 18 * unit, 4 * unit}, theme, unit, {*scale});
    } else if (sheet.style.colors.by == ColorBy::subtree) {
        draw_side_panel(overlay, {sheet_margin, key_y, layout.width - 2 * sheet_margin, 2 * unit},
                        theme, unit, {PanelNote{"color: the subtree below the third division"}});
    } else {
        int x = sheet_margin;
        const auto& bodies = sheet.rows.front().front().bodies;
        const TextStyle style{unit, FontWeight::regular, theme.text};
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const ItemCount held = item_count(*bodies[b].mesh, *bodies[b].tree);
            const std::string text = "body " + bodies[b].name + ", " + count_text(held.count) +
                                     " " + std::string(held.what);
            const int width = unit * 5 / 4 + overlay.measure(text, style).width + 2 * unit;
            if (x + width > layout.width - 6 * unit && b + 1 < bodies.size()) {
                overlay.text(x, key_y, "and " + std::to_string(bodies.size() - b) + " more", style);
                break;
            }
            draw_side_panel(overlay, {x, key_y, width, 2 * unit}, theme, unit,
                            {PanelKey{category_color(b), text}});
            x += width;
        }
    }

    const bool beside = legend_of(sheet.style.colors).has_value();
    const int note_x = sheet_margin + (beside ? 19 * unit : 0),
              note_y = key_y + (beside ? 0 : 7 * unit / 4);
    draw_side_panel(overlay,
                    {note_x, note_y, layout.width - sheet_margin - note_x,
                     level_heading_height(unit) - unit / 2 - note_y},
                    theme, unit, {PanelNote{sheet.note}});

    const int first_y = level_heading_height(unit);
    for (std::size_t r = 0; r < sheet.rows.size(); ++r)
        for (std::size_t c = 0; c < levels; ++c) {
            const LevelSheetCell& cell = sheet.rows[r][c];
            const int band = static_cast<int>(c) / layout.columns,
                      column = static_cast<int>(c) % layout.columns;
            const int x = layout.x(column);
            const int y =
                first_y + (band * static_cast<int>(sheet.rows.size()) + static_cast<int>(r)) *
                              cell_height(layout);
            const LevelNumbers numbers = level_numbers(cell.bodies, cell.level);

            const TextStyle bold{unit, FontWeight::bold, theme.text};
            std::string counts;
            for (const VolumeStatistics& v : numbers.bodies)
                counts += (counts.empty() ? "" : " + ") + count_text(v.volumes);
            if (numbers.bodies.size() > 3) counts = count_text(numbers.all.volumes);
            counts += counts == "1" ? " volume" : " volumes";
            const TextStyle right{unit, FontWeight::regular, theme.text, Align::right};
            const TextStyle faint{small_size(unit), FontWeight::regular, theme.faint_text};
            const int room = layout.view_width - overlay.measure(counts, right).width - unit;
            std::string second = "mean d " + number_text(numbers.all.mean_diameter()) +
                                 ", mean τ " + thickness_text(numbers.all) + ", Σ volume " +
                                 volume_text(numbers.all);
            if (overlay.measure(cell.caption, bold).width <= room)
                overlay.text(x + layout.view_width, y, counts, right);
            else
                second = counts;  // a narrow cell: the counts matter most
            overlay.text(x, y, fitted_text(overlay, cell.caption, bold, layout.view_width), bold);
            overlay.text(x, y + unit * 5 / 4,
                         fitted_text(overlay, second, faint, layout.view_width), faint);

            const PixelRect view{x, y + unit * 5 / 2, layout.view_width, layout.view_height};
            picture.panes.push_back(
                level_pane(view, cell.camera, cell.bodies, cell.level, sheet.style));
            overlay.frame(view, theme.border);
            draw_length_histogram(overlay,
                                  {x, view.y + view.height + layout.detail_size + unit / 2,
                                   layout.view_width, histogram_height(layout)},
                                  level_lengths(cell.bodies, cell.level, sheet.style),
                                  {theme, unit});
            if (c == 0 || !same_view(cell.camera, sheet.rows[r][c - 1].camera))
                draw_scale_bar(overlay, view, cell.camera, sheet.center, theme, unit);
            if (!sheet.detail) continue;
            const PixelRect square{x + (layout.view_width - layout.detail_size) / 2,
                                   view.y + view.height, layout.detail_size, layout.detail_size};
            picture.panes.push_back(
                level_pane(square, sheet.detail->camera, cell.bodies, cell.level, sheet.style));
            overlay.frame(square, theme.accent, 2);
            if (const auto marker =
                    marker_of(view, cell.camera, sheet.detail->center, sheet.detail->radius)) {
                overlay.frame(*marker, theme.accent, 2);
            }
            overlay.text(square.x + square.width + unit / 2,
                         square.y + square.height - small_size(unit) * 5 / 4,
                         number_text(2 * sheet.detail->radius) + " wide", faint);
        }
    return picture;
}

}  // namespace scb::render
