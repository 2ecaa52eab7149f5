#include "render/figures/frame_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "render/overlay/figure_layout.h"

namespace scb::render {
namespace {

/// Details with a dot between them, as many as fit.
std::string fitted_details(Overlay& overlay, const std::vector<std::string>& details,
                           const TextStyle& style, int width) {
    std::string text;
    for (const std::string& detail : details) {
        const std::string longer = text.empty() ? detail : text + " · " + detail;
        if (overlay.measure(longer, style).width > width) break;
        text = longer;
    }
    return text;
}

/// Draws the legend under the title. Returns the y below it.
int draw_legend(Overlay& overlay, const FrameSheet& sheet, int y) {
    const int unit = sheet.layout.unit, right = sheet.layout.width - sheet_margin;
    if (sheet.scale) {
        PanelScale scale = *sheet.scale;
        if (sheet.scales_differ) scale.ticks = {{0, "0"}, {1, "end of the picture's scale"}};
        const PixelRect box = {sheet_margin, y, std::min(24 * unit, right - sheet_margin),
                               4 * unit};
        return draw_side_panel(overlay, box, *sheet.theme, unit, {scale});
    }
    int x = sheet_margin;
    for (PanelKey key : sheet.keys) {
        const TextStyle style{unit, FontWeight::regular, sheet.theme->text};
        key.text = fitted_text(overlay, key.text, style, right - sheet_margin - unit * 3 / 2);
        const int width = unit * 5 / 4 + overlay.measure(key.text, style).width + unit / 4;
        if (x > sheet_margin && x + width > right) {
            x = sheet_margin;
            y += unit * 5 / 4;
        }
        draw_side_panel(overlay, {x, y, width, 2 * unit}, *sheet.theme, unit, {key});
        x += width + unit * 3 / 2;
    }
    return y + unit * 5 / 4;
}

/// Draws title and legend. Returns their height.
int draw_heading(Overlay& overlay, const FrameSheet& sheet) {
    FigureLayout frame;
    frame.unit = sheet.layout.unit;
    const int title = title_size(frame.unit);
    frame.heading = {sheet_margin, sheet_margin, sheet.layout.width - 2 * sheet_margin, title};
    draw_heading(overlay, frame, *sheet.theme, sheet.title, sheet.subtitle);
    return draw_legend(overlay, sheet, sheet_margin + title + frame.unit / 2) + frame.unit * 3 / 4;
}

void draw_captions(Overlay& overlay, const FrameSheet& sheet, const FrameSheetCell& cell, int x) {
    const Theme& theme = *sheet.theme;
    const int unit = sheet.layout.unit, width = sheet.layout.view_width;
    const TextStyle bold{unit, FontWeight::bold, theme.text};
    const TextStyle right{unit, FontWeight::regular, theme.text, Align::right};
    const TextStyle faint{small_size(unit), FontWeight::regular, theme.faint_text};
    const int y = unit / 4;
    overlay.rectangle({x, 0, width, 1}, theme.border);
    std::vector<std::string> details = cell.details;
    if (sheet.scales_differ) details.insert(details.begin(), "scale to " + cell.scale_end);
    if (overlay.measure(cell.caption, bold).width + unit +
            overlay.measure(cell.value, right).width <=
        width)
        overlay.text(x + width, y, cell.value, right);
    else
        details.insert(details.begin(), cell.value);
    overlay.text(x, y, fitted_text(overlay, cell.caption, bold, width), bold);
    overlay.text(x, y + unit * 5 / 4, fitted_details(overlay, details, faint, width), faint);
}

void place(const Image& view, Image& image, int x, int y) {
    const std::size_t bytes = 4 * static_cast<std::size_t>(view.width);
    for (int row = 0; row < view.height; ++row) {
        const std::size_t to =
            static_cast<std::size_t>(y + row) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(x);
        std::memcpy(&image.rgba[4 * to], &view.rgba[static_cast<std::size_t>(row) * bytes], bytes);
    }
}

}  // namespace

void add_legend(FrameSheet& sheet, const std::vector<PanelItem>& panel) {
    const auto add = [&](Rgba8 color, const std::string& text) {
        const auto same = [&](const PanelKey& key) {
            return key.color == color && key.text == text;
        };
        if (std::none_of(sheet.keys.begin(), sheet.keys.end(), same))
            sheet.keys.push_back({color, text});
    };
    std::vector<std::string> names;
    for (const PanelItem& item : panel) {
        if (const auto* key = std::get_if<PanelKey>(&item)) add(key->color, key->text);
        if (const auto* row = std::get_if<PanelLegendRow>(&item)) add(row->color, row->text);
        if (const auto* row = std::get_if<PanelRow>(&item)) {
            if (row->strong && !row->swatches.empty()) names = row->values;
            for (std::size_t i = 0; i < row->swatches.size(); ++i) {
                if (!row->swatches[i]) continue;
                // Counts are for one picture, but the bodies' names are for all.
                if (row->strong)
                    add(*row->swatches[i], row->label + " " + row->values[i]);
                else
                    add(*row->swatches[i], row->label + (i < names.size() ? ", " + names[i] : ""));
            }
        }
        if (const auto* scale = std::get_if<PanelScale>(&item)) {
            sheet.scales_differ |= sheet.scale && sheet.scale->ticks != scale->ticks;
            sheet.scale = *scale;
        }
    }
}

std::string scale_end(const std::vector<PanelItem>& panel) {
    for (const PanelItem& item : panel)
        if (const auto* scale = std::get_if<PanelScale>(&item))
            return scale->ticks.empty() ? "" : scale->ticks.back().second;
    return "";
}

Image draw(const FrameSheet& sheet, Renderer& renderer, Overlay& overlay) {
    const FrameSheetLayout& layout = sheet.layout;
    Picture strip{layout.width, 0, 1, sheet.theme->background, {}};
    overlay.begin();
    strip.height = draw_heading(overlay, sheet);
    Image image = renderer.draw(strip, &overlay).image;
    strip.height = layout.cell_height();
    const auto columns = static_cast<std::size_t>(layout.columns);
    for (std::size_t first = 0; first < sheet.cells.size(); first += columns) {
        const std::span cells =
            std::span(sheet.cells).subspan(first, std::min(columns, sheet.cells.size() - first));
        overlay.begin();
        for (std::size_t i = 0; i < cells.size(); ++i)
            draw_captions(overlay, sheet, cells[i], layout.x(static_cast<int>(i)));
        Image band = renderer.draw(strip, &overlay).image;
        for (std::size_t i = 0; i < cells.size(); ++i)
            place(cells[i].view, band, layout.x(static_cast<int>(i)), layout.view_y());
        image.rgba.insert(image.rgba.end(), band.rgba.begin(), band.rgba.end());
        image.height += band.height;
    }
    return image;
}

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
