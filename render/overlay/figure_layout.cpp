#include "render/overlay/figure_layout.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/scales.h"

namespace scb::render {

FigureLayout figure_layout(int width, int height, bool with_panel) {
    FigureLayout layout;
    const int unit = layout.unit = text_unit(width, height);
    if (!with_panel) {
        layout.view = {0, 0, width, height};
        return layout;
    }
    const int margin = std::min({unit, width / 24, height / 24});
    const int heading = std::min(height / 4, title_size(unit) + unit / 2);
    const int top = margin + heading;
    layout.heading = {margin, margin, width - 2 * margin, heading};
    layout.portrait = height > width;
    if (layout.portrait) {
        const int panel = std::min(height / 3, 14 * unit * 5 / 4);
        const int rows = std::min(15 * unit, width - 2 * margin);
        layout.panel = {margin, height - margin - panel, rows, panel};
        layout.view = {margin, top, width - 2 * margin, std::max(1, layout.panel.y - margin - top)};
    } else {
        const int panel = std::min(width * 2 / 5, 15 * unit);
        layout.panel = {width - margin - panel, top, panel, height - top - margin};
        layout.view = {margin, top, std::max(1, width - 3 * margin - panel),
                       std::max(1, height - top - margin)};
    }
    return layout;
}

std::optional<PixelRect> detail_square(const FigureLayout& layout, int below) {
    const PixelRect& panel = layout.panel;
    const int caption = layout.unit * 9 / 4;
    PixelRect square{panel.x, below + caption, 0, 0};
    square.width = std::min(panel.width, panel.y + panel.height - square.y);
    if (layout.portrait) {
        const int right = layout.view.x + layout.view.width;
        square = {panel.x + panel.width + 2 * layout.unit, panel.y + caption / 2, 0, 0};
        square.width = std::min(right - square.x, panel.y + panel.height - square.y);
        square.x = right - square.width;
    }
    square.height = square.width;
    if (square.width < 4 * layout.unit) return std::nullopt;
    return square;
}

void draw_detail_frames(Overlay& overlay, const FigureLayout& layout, const PixelRect& square,
                        const Camera& camera, const Detail& detail, const Theme& theme) {
    const int thickness = std::max(1, layout.unit / 10);
    const TextStyle caption{small_size(layout.unit), FontWeight::regular, theme.faint_text};
    const std::string text = detail.shows_whole
                                 ? "the whole; square: the view"
                                 : "detail, " + number_text(2 * detail.radius) + " wide";
    // In a corner of the view, a wide text would reach into the panel.
    const int right = square.x < layout.view.x + layout.view.width && !layout.portrait
                          ? square.x + square.width
                          : layout.panel.x + layout.panel.width,
              beyond = std::max(0, square.x + overlay.measure(text, caption).width - right);
    const int x = square.x - beyond, y = square.y - small_size(layout.unit) * 5 / 4;
    const TextSize size = overlay.measure(text, caption);
    overlay.rectangle({x, y, size.width, size.height}, theme.panel);
    overlay.text(x, y, text, caption);
    if (detail.shows_whole) return draw_square_of_view(overlay, layout.unit, square, detail, theme);
    overlay.frame(square, theme.accent, thickness);
    if (const auto marker = marker_of(layout.view, camera, detail.center, detail.radius))
        overlay.frame(*marker, theme.accent, thickness);
}

void draw_square_of_view(Overlay& overlay, int unit, const PixelRect& square, const Detail& detail,
                         const Theme& theme) {
    const int thickness = std::max(1, unit / 10);
    overlay.frame(square, theme.accent, thickness);
    if (const auto marker = marker_of(square, detail.camera, detail.center, detail.radius))
        overlay.frame(*marker, theme.accent, thickness);
}

namespace {

/// If a title is too long, its first part, the scene's name, is cut at the end: the content of the
/// picture follows it.
std::string fitted_title(Overlay& overlay, std::string_view title, const TextStyle& style,
                         int width) {
    const std::string_view rest = title.substr(std::min(title.find(" · "), title.size()));
    const std::string_view scene = title.substr(0, title.size() - rest.size());
    const int room = width - overlay.measure(rest, style).width;
    if (overlay.measure(title, style).width <= width || room < width / 4)
        return fitted_text(overlay, title, style, width);
    return fitted_text(overlay, scene, style, room) + std::string(rest);
}

}  // namespace

int second_heading_line(Overlay& overlay, const FigureLayout& layout, std::string_view title,
                        std::string_view subtitle) {
    const int unit = layout.unit,
              width = overlay.measure(title, {title_size(unit), FontWeight::bold, {}}).width +
                      unit + overlay.measure(subtitle, {unit, FontWeight::regular, {}}).width;
    return subtitle.empty() || width <= layout.heading.width ? 0 : unit * 5 / 4;
}

void draw_heading(Overlay& overlay, const FigureLayout& layout, const Theme& theme,
                  std::string_view title, std::string_view subtitle) {
    const int unit = layout.unit;
    const PixelRect& box = layout.heading;
    TextStyle title_style{title_size(unit), FontWeight::bold, theme.text};
    const TextStyle subtitle_style{unit, FontWeight::regular, theme.faint_text};
    while (title_style.size > unit && overlay.measure(title, title_style).width > box.width)
        --title_style.size;
    const int below = second_heading_line(overlay, layout, title, subtitle);
    if (below > 0 && box.height >= title_size(unit) + below) {
        overlay.text(box.x, box.y + title_size(unit) + unit / 8,
                     fitted_text(overlay, subtitle, subtitle_style, box.width), subtitle_style);
        subtitle = {};
    }
    const std::string shown = fitted_title(overlay, title, title_style, box.width);
    overlay.text(box.x, box.y + (title_size(unit) - title_style.size) * 4 / 5, shown, title_style);
    const int used = overlay.measure(shown, title_style).width + unit;
    const std::string remark = fitted_text(overlay, subtitle, subtitle_style, box.width - used);
    // Both on one base line.
    overlay.text(box.x + used, box.y + (title_size(unit) - unit) * 4 / 5, remark, subtitle_style);
}

std::string fitted_text(Overlay& overlay, std::string_view text, const TextStyle& style,
                        int width) {
    std::string shown(text);
    if (overlay.measure(shown, style).width <= width) return shown;
    while (!shown.empty()) {
        // Whole characters: bytes 10xxxxxx continue one.
        while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0) == 0x80)
            shown.pop_back();
        if (!shown.empty()) shown.pop_back();
        const std::string cut = shown + "…";
        if (overlay.measure(cut, style).width <= width) return cut;
    }
    return shown;
}

std::vector<std::string> wrapped_text(Overlay& overlay, std::string_view text,
                                      const TextStyle& style, int width) {
    std::vector<std::string> lines;
    std::string line;
    const auto flush = [&] {
        if (!line.empty()) lines.push_back(line);
        line.clear();
    };
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::string longer =
            line.empty() ? std::string(word) : line + " " + std::string(word);
        if (overlay.measure(longer, style).width <= width) {
            line = longer;
        } else {
            flush();
            line = fitted_text(overlay, word, style, width);
        }
    }
    flush();
    return lines;
}

void draw_scale_bar(Overlay& overlay, const PixelRect& view, const Camera& camera, const Vec3& at,
                    const Theme& theme, int unit, int below) {
    const double scale = pixels_per_unit(camera, at, view.height);
    if (!(scale > 0) || !std::isfinite(scale)) return;
    draw_scale_bar(overlay, view.x + unit / 2, view.y + view.height - unit / 2 + below,
                   view.width / 5, scale, {theme, unit});
}

void draw_remark(Overlay& overlay, const PixelRect& view, std::string_view remark,
                 const Theme& theme, int unit) {
    if (remark.empty()) return;
    const TextStyle style{unit, FontWeight::bold, theme.accent};
    const std::string text = fitted_text(overlay, remark, style, view.width);
    const TextSize size = overlay.measure(text, style);
    overlay.rectangle({view.x, view.y, std::min(view.width, size.width + unit / 4), size.height},
                      theme.panel);
    overlay.text(view.x, view.y, text, style);
}

std::optional<PixelRect> marker_of(const PixelRect& view, const Camera& camera, const Vec3& center,
                                   double radius) {
    if (!(-to_eye(camera, center)[2] > 0)) return std::nullopt;
    const Vec3 at = project(camera, center, view.width, view.height);
    const double reach = radius * pixels_per_unit(camera, center, view.height);
    if (!(at[0] - reach >= 0 && at[1] - reach >= 0 && at[0] + reach <= view.width &&
          at[1] + reach <= view.height))
        return std::nullopt;
    const int side = std::max(3, static_cast<int>(std::lround(2 * reach)));
    return PixelRect{view.x + static_cast<int>(std::lround(at[0] - reach)),
                     view.y + static_cast<int>(std::lround(at[1] - reach)), side, side};
}

std::string number_text(double value, int digits) {
    if (std::abs(value) >= 100 && std::abs(value) < 1e7 && digits <= 3)
        return (value < 0 ? "-" : "") +
               count_text(static_cast<std::uint64_t>(std::llround(std::abs(value))));
    // With '#' the zeros stay, so that numbers in a column have equal digits. A point at the end is
    // removed.
    std::string result = format("%#.*g", digits, value);
    if (const std::size_t exponent = result.find('e'); exponent != std::string::npos) {
        if (exponent > 0 && result[exponent - 1] == '.') result.erase(exponent - 1, 1);
    } else if (result.back() == '.') {
        result.pop_back();
    }
    return value == 0 ? "0" : result;
}

std::string mean_text(std::uint64_t sum, std::size_t frames) {
    if (frames <= 1) return count_text(sum);
    const auto tenths = static_cast<std::uint64_t>(
        std::llround(10 * static_cast<double>(sum) / static_cast<double>(frames)));
    return count_text(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string share_text(double part, double whole) {
    if (!(whole > 0)) return "–";
    return format("%.1f %%", 100 * part / whole);
}

int SheetGrid::x(int column) const { return sheet_margin + column * (view_width + sheet_margin); }

SheetGrid sheet_grid(int count, int most_columns, int view_width) {
    SheetGrid grid;
    grid.bands = (count + most_columns - 1) / most_columns;
    grid.columns = (count + grid.bands - 1) / grid.bands;
    grid.view_width = view_width;
    grid.unit = std::clamp(view_width / 20, 14, 28);
    grid.width = grid.x(grid.columns);
    return grid;
}

int roomy_view_width(int columns) { return columns <= 2 ? 620 : columns <= 3 ? 520 : 440; }

bool fits(const SheetGrid& grid) {
    return grid.width <= largest_sheet_side && grid.height <= largest_sheet_side;
}

}  // namespace scb::render
