#include "render/figures/level_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/model/level_statistics.h"
#include "render/figures/figure_words.h"
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

/// The bodies by color, in one line, as far as there is room.
void draw_body_keys(Overlay& overlay, const LevelSheet& sheet, int y) {
    const Theme& theme = *sheet.style.theme;
    const int unit = sheet.layout.unit;
    int x = sheet_margin;
    const auto& bodies = sheet.rows.front().front().bodies;
    const TextStyle style{unit, FontWeight::regular, theme.text};
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const ItemCount held = item_count(*bodies[b].mesh, *bodies[b].tree);
        const std::string text =
            "body " + bodies[b].name + ", " + count_text(held.count) + " " + std::string(held.what);
        const int width = unit * 5 / 4 + overlay.measure(text, style).width + 2 * unit;
        if (x + width > sheet.layout.width - 6 * unit && b + 1 < bodies.size()) {
            overlay.text(x, y, "and " + std::to_string(bodies.size() - b) + " more", style);
            break;
        }
        draw_side_panel(overlay, {x, y, width, 2 * unit}, theme, unit,
                        {PanelKey{category_color(b), text}});
        x += width;
    }
}

/// The colors under the heading, and the note beside the scale or below the keys.
void draw_legend(Overlay& overlay, const LevelSheet& sheet) {
    const Theme& theme = *sheet.style.theme;
    const int unit = sheet.layout.unit, y = sheet_margin + title_size(unit) + unit / 2,
              width = sheet.layout.width - 2 * sheet_margin;
    PixelRect note{sheet_margin, y + 7 * unit / 4, width, 0};
    if (const std::optional<PanelScale> scale = legend_of(sheet.style.colors)) {
        draw_side_panel(overlay, {sheet_margin, y, 18 * unit, 4 * unit}, theme, unit, {*scale});
        note = {sheet_margin + 19 * unit, y, width - 19 * unit, 0};
    } else if (sheet.style.colors.by == ColorBy::subtree) {
        draw_side_panel(overlay, {sheet_margin, y, width, 2 * unit}, theme, unit,
                        {PanelNote{"color: the subtree below the third division"}});
    } else {
        draw_body_keys(overlay, sheet, y);
    }
    note.height = level_heading_height(unit) - unit / 2 - note.y;
    draw_side_panel(overlay, note, theme, unit, {PanelNote{sheet.note}});
}

/// Caption and numbers above a view.
void draw_cell_text(Overlay& overlay, const LevelSheet& sheet, const LevelSheetCell& cell, int x,
                    int y) {
    const Theme& theme = *sheet.style.theme;
    const int unit = sheet.layout.unit, width = sheet.layout.view_width;
    const LevelNumbers numbers = level_numbers(cell.bodies, cell.level);
    std::string counts;
    for (const VolumeStatistics& v : numbers.bodies)
        counts += (counts.empty() ? "" : " + ") + count_text(v.volumes);
    if (numbers.bodies.size() > 3) counts = count_text(numbers.all.volumes);
    counts += counts == "1" ? " volume" : " volumes";
    const TextStyle bold{unit, FontWeight::bold, theme.text};
    const TextStyle right{unit, FontWeight::regular, theme.text, Align::right};
    const TextStyle faint{small_size(unit), FontWeight::regular, theme.faint_text};
    const int room = width - overlay.measure(counts, right).width - unit;
    std::string second = "mean d " + number_text(numbers.all.mean_diameter()) + ", mean τ " +
                         thickness_text(numbers.all) + ", Σ volume " + volume_text(numbers.all);
    if (overlay.measure(cell.caption, bold).width <= room)
        overlay.text(x + width, y, counts, right);
    else
        second = counts;  // a narrow cell: the counts matter most
    overlay.text(x, y, fitted_text(overlay, cell.caption, bold, width), bold);
    overlay.text(x, y + unit * 5 / 4, fitted_text(overlay, second, faint, width), faint);
}

/// All levels of a large mesh have millions of volumes, so a pane gets its volumes when it is
/// drawn.
Pane cell_pane(const PixelRect& viewport, const Camera& camera, const LevelSheetCell& cell,
               const LevelStyle& style) {
    Pane pane;
    pane.viewport = viewport;
    pane.camera = camera;
    pane.add_contents = [bodies = cell.bodies, level = cell.level, style](Pane& drawn) {
        drawn = level_pane(drawn.viewport, drawn.camera, bodies, level, style);
    };
    return pane;
}

/// The detail below a view, and its place in the view.
void draw_detail(Overlay& overlay, Picture& picture, const LevelSheet& sheet,
                 const LevelSheetCell& cell, const PixelRect& view) {
    const Theme& theme = *sheet.style.theme;
    const int unit = sheet.layout.unit, size = sheet.layout.detail_size;
    const PixelRect square{view.x + (view.width - size) / 2, view.y + view.height, size, size};
    picture.panes.push_back(cell_pane(square, sheet.detail->camera, cell, sheet.style));
    overlay.frame(square, theme.accent, 2);
    if (const auto marker =
            marker_of(view, cell.camera, sheet.detail->center, sheet.detail->radius))
        overlay.frame(*marker, theme.accent, 2);
    overlay.text(square.x + square.width + unit / 2,
                 square.y + square.height - small_size(unit) * 5 / 4,
                 number_text(2 * sheet.detail->radius) + " wide",
                 {small_size(unit), FontWeight::regular, theme.faint_text});
}

void draw_cell(Overlay& overlay, Picture& picture, const LevelSheet& sheet,
               const LevelSheetCell& cell, int x, int y, bool has_scale_bar) {
    const LevelSheetLayout& layout = sheet.layout;
    const Theme& theme = *sheet.style.theme;
    const int unit = layout.unit;
    draw_cell_text(overlay, sheet, cell, x, y);
    const PixelRect view{x, y + unit * 5 / 2, layout.view_width, layout.view_height};
    picture.panes.push_back(cell_pane(view, cell.camera, cell, sheet.style));
    overlay.frame(view, theme.border);
    draw_length_histogram(overlay,
                          {x, view.y + view.height + layout.detail_size + unit / 2,
                           layout.view_width, histogram_height(layout)},
                          level_lengths(cell.bodies, cell.level, sheet.style), {theme, unit});
    if (has_scale_bar) draw_scale_bar(overlay, view, cell.camera, sheet.center, theme, unit);
    if (sheet.detail) draw_detail(overlay, picture, sheet, cell, view);
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
    // The height is limited to twice the width, if possible.
    for (int wider = most_level_columns; wider <= 2 * most_level_columns; ++wider)
        if (lay_out(std::min(count, wider), roomy) && layout.height <= 2 * layout.width)
            return layout;
    for (int view_width = roomy; view_width >= 160; view_width -= 20)
        for (int wider = most_level_columns; wider <= count + most_level_columns; wider += 2)
            if (lay_out(std::min(count, wider), view_width)) return layout;
    return layout;
}

Picture compose(const LevelSheet& sheet, int samples, Overlay& overlay) {
    const LevelSheetLayout& layout = sheet.layout;
    const Theme& theme = *sheet.style.theme;
    Picture picture{layout.width, layout.height, samples, theme.background, {}};
    overlay.begin();

    FigureLayout frame;
    frame.unit = layout.unit;
    frame.heading = {sheet_margin, sheet_margin, layout.width - 2 * sheet_margin,
                     title_size(layout.unit)};
    draw_heading(overlay, frame, theme, sheet.title, sheet.subtitle);
    draw_legend(overlay, sheet);
    const int rows = static_cast<int>(sheet.rows.size());
    for (int r = 0; r < rows; ++r) {
        const std::vector<LevelSheetCell>& cells = sheet.rows[static_cast<std::size_t>(r)];
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const int c = static_cast<int>(i), band = c / layout.columns;
            draw_cell(overlay, picture, sheet, cells[i], layout.x(c % layout.columns),
                      level_heading_height(layout.unit) + (band * rows + r) * cell_height(layout),
                      i == 0 || !same_view(cells[i].camera, cells[i - 1].camera));
        }
    }
    return picture;
}

}  // namespace scb::render
