#include "render/overlay/side_panel.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "render/overlay/figure_layout.h"
#include "render/overlay/scales.h"

namespace scb::render {
namespace {

/// "1,024", "+432", "−17", "±0".
bool is_number(std::string_view text) {
    for (const std::string_view sign : {"+", "−", "±"})
        if (text.starts_with(sign)) text.remove_prefix(sign.size());
    return !text.empty() && text[0] >= '0' && text[0] <= '9';
}

struct PanelPainter {
    Overlay& overlay;
    const PixelRect& box;
    const Theme& theme;
    int unit;
    const std::vector<PanelItem>& items;
    int y;
    int kept_free;
    std::size_t current = 0;                                    ///< the current item
    std::map<std::size_t, std::vector<int>> ends_by_columns{};  ///< see column_ends

    int line_height() const { return unit * 5 / 4; }
    bool fits(int height) const { return y + height <= box.y + box.height; }
    TextStyle style(FontWeight weight, Rgba8 color, Align align = Align::left) const {
        return {unit, weight, color, align};
    }

    int least(const PanelItem& item) const {
        if (std::holds_alternative<PanelScale>(item)) return scale_height();
        const auto* note = std::get_if<PanelNote>(&item);
        return note == nullptr ? line_height() : note_height(note_lines(*note).size());
    }
    /// The height of the heading with the smallest item under it.
    int least_below(std::size_t heading) const {
        const int own = line_height() + unit / 4;
        std::size_t i = heading + 1;
        if (i == items.size()) return own;
        if (std::holds_alternative<PanelHeading>(items[i])) return own + least_below(i);
        // Heads of columns need a row below them.
        if (const auto* row = std::get_if<PanelRow>(&items[i]);
            row != nullptr && row->label.empty() && i + 1 < items.size())
            return own + line_height() + least(items[i + 1]);
        int smallest = least(items[i]);
        for (; i < items.size() && !std::holds_alternative<PanelHeading>(items[i]); ++i)
            smallest = std::min(smallest, least(items[i]));
        return own + smallest;
    }
    /// The height of the items below the current one, without notes, which may be left out.
    int least_of_rest() const {
        int sum = kept_free;
        for (std::size_t i = current + 1; i < items.size(); ++i) {
            if (std::holds_alternative<PanelNote>(items[i])) continue;
            if (std::holds_alternative<PanelHeading>(items[i])) sum += unit / 2 + unit / 4;
            sum += least(items[i]);
        }
        return sum;
    }
    TextStyle note_style() const {
        return {small_size(unit), FontWeight::regular, theme.faint_text};
    }
    std::vector<std::string> note_lines(const PanelNote& note) const {
        return wrapped_text(overlay, note.text, note_style(), box.width);
    }
    int note_height(std::size_t lines) const {
        return static_cast<int>(lines) * (small_size(unit) * 5 / 4);
    }
    int gap() const { return y > box.y ? unit / 2 : 0; }
    int scale_height() const { return line_height() + unit * 3 / 4 + small_size(unit) + unit / 2; }

    void draw(const PanelHeading& heading) {
        y += gap();
        const TextStyle bold = style(FontWeight::bold, theme.text);
        overlay.text(box.x, y, fitted_text(overlay, heading.text, bold, box.width), bold);
        y += line_height();
        overlay.rectangle({box.x, y, box.width, 1}, theme.border);
        y += unit / 4;
    }

    /// The ends of the label and of each value, in rows with this number of values, from the left
    /// of the box.
    std::vector<int> column_ends(std::size_t columns) const {
        // Labels are narrower beside several columns.
        const int label = columns == 0 ? box.width : box.width * (columns == 1 ? 11 : 8) / 20;
        std::vector<int> ends = {label}, needed(columns + 1), numbers(columns + 1);
        for (std::size_t c = 1; c <= columns; ++c)
            ends.push_back(label +
                           (box.width - label) * static_cast<int>(c) / static_cast<int>(columns));
        for (const PanelItem& item : items) {
            const auto* row = std::get_if<PanelRow>(&item);
            if (row == nullptr || row->values.size() != columns) continue;
            const auto need = [&](std::size_t c, const std::string& text, FontWeight weight,
                                  bool swatch) {
                const int width = overlay.measure(text, style(weight, theme.text)).width +
                                  unit / 4 + (swatch ? unit * 5 / 4 : 0);
                needed[c] = std::max(needed[c], width);
                if (c == 0 || is_number(text)) numbers[c] = std::max(numbers[c], width);
            };
            need(0, row->label, FontWeight::regular, false);
            for (std::size_t c = 0; c < columns; ++c)
                need(c + 1, row->values[c], row->strong ? FontWeight::bold : FontWeight::regular,
                     c < row->swatches.size() && row->swatches[c].has_value());
        }
        // If not all fits into columns of equal width, each column has the width that it needs; or
        // at least the width of its numbers, which are never cut.
        for (const std::vector<int>& widths : {needed, numbers}) {
            const int sum = std::accumulate(widths.begin(), widths.end(), 0);
            bool fit = true;
            for (std::size_t c = 1; c <= columns; ++c) fit &= widths[c] <= ends[c] - ends[c - 1];
            if (fit) return ends;
            if (sum > box.width) continue;
            const int spare = (box.width - sum) / static_cast<int>(columns + 1);
            int end = 0;
            for (std::size_t c = 0; c < columns; ++c) ends[c] = end += widths[c] + spare;
            return ends;
        }
        return ends;
    }

    void draw(const PanelRow& row) {
        if (!fits(line_height())) return;
        const FontWeight weight = row.strong ? FontWeight::bold : FontWeight::regular;
        const TextStyle label = style(FontWeight::regular, theme.faint_text);
        const TextStyle value = style(weight, theme.text, Align::right);
        auto& ends = ends_by_columns[row.values.size()];
        if (ends.empty()) ends = column_ends(row.values.size());
        overlay.text(box.x, y, fitted_text(overlay, row.label, label, ends[0]), label);
        for (std::size_t i = 0; i < row.values.size(); ++i) {
            const int right = box.x + ends[i + 1], room = ends[i + 1] - ends[i] - unit / 4;
            const bool swatch = i < row.swatches.size() && row.swatches[i].has_value();
            // Names may be cut; numbers are set smaller instead.
            const bool number = is_number(row.values[i]);
            TextStyle style_of_value = value;
            const int limit = swatch ? room - unit * 5 / 4 : room;
            while (number && style_of_value.size > 8 &&
                   overlay.measure(row.values[i], style_of_value).width > limit)
                --style_of_value.size;
            const std::string text =
                number ? row.values[i] : fitted_text(overlay, row.values[i], value, limit);
            overlay.text(right, y + (unit - style_of_value.size) / 2, text, style_of_value);
            if (swatch) {
                const int x = right - overlay.measure(text, value).width - unit * 5 / 4;
                overlay.rectangle({x, y + unit / 10, unit * 4 / 5, unit * 4 / 5}, *row.swatches[i]);
            }
        }
        y += line_height();
    }

    void draw(const PanelKey& key) {
        if (!fits(line_height())) return;
        overlay.rectangle({box.x, y + unit / 10, unit * 4 / 5, unit * 4 / 5}, key.color);
        const TextStyle text = style(FontWeight::regular, theme.text);
        const int indent = unit * 5 / 4;
        overlay.text(box.x + indent, y, fitted_text(overlay, key.text, text, box.width - indent),
                     text);
        y += line_height();
    }

    void draw_swatch(Rgba8 color, bool hatched) {
        const PixelRect square = {box.x, y + unit / 10, unit * 4 / 5, unit * 4 / 5};
        overlay.rectangle(square, color);
        if (!hatched) return;
        // Hatched as in the view: two of seven pixels.
        const Rgba8 dark = mix(color, {0, 0, 0, 255}, 0.4);
        for (int row = 0; row < square.height; ++row)
            for (int column = -row % 7; column < square.width; column += 7) {
                const int from = std::max(column, 0), to = std::min(column + 2, square.width);
                overlay.rectangle({square.x + from, square.y + row, to - from, 1}, dark);
            }
    }

    void draw(const PanelLegendRow& row) {
        if (!fits(line_height())) return;
        draw_swatch(row.color, row.hatched);
        TextStyle text = style(FontWeight::regular, theme.text);
        const TextStyle value = style(FontWeight::regular, theme.text, Align::right);
        const TextStyle faint = style(FontWeight::regular, theme.faint_text, Align::right);
        const int right = box.x + box.width, share = row.share.empty() ? 0 : unit * 7 / 2,
                  indent = unit * 5 / 4;
        overlay.text(right, y, row.share, faint);
        overlay.text(right - share, y, row.count, value);
        const int room =
            box.width - indent - share - overlay.measure(row.count, value).width - unit / 2;
        while (text.size > small_size(unit) && overlay.measure(row.text, text).width > room)
            --text.size;
        const int top = y + (unit - text.size) / 2, second_line = text.size * 5 / 4;
        const std::string first = first_line(row.text, text, room);
        y += line_height();
        if (first.size() == row.text.size() || !fits(second_line + least_of_rest())) {
            overlay.text(box.x + indent, top, fitted_text(overlay, row.text, text, room), text);
            return;
        }
        overlay.text(box.x + indent, top, first, text);
        const std::string second = row.text.substr(first.size() + 1);
        overlay.text(box.x + indent, top + second_line,
                     fitted_text(overlay, second, text, box.width - indent), text);
        y += second_line;
    }

    /// The words that fit into a line; all if not even one fits.
    std::string first_line(const std::string& text, const TextStyle& style, int width) const {
        if (overlay.measure(text, style).width <= width) return text;
        for (std::size_t end = text.rfind(' '); end != std::string::npos && end > 0;
             end = text.rfind(' ', end - 1))
            if (overlay.measure(text.substr(0, end), style).width <= width)
                return text.substr(0, end);
        return text;
    }

    void draw(const PanelScale& scale) {
        if (!fits(scale_height())) return;
        std::vector<Tick> ticks;
        for (const auto& [at, label] : scale.ticks) ticks.push_back({at, label});
        const PixelRect covered =
            draw_color_bar(overlay, {box.x, y + line_height(), box.width, unit * 3 / 4},
                           scale.color, scale.title, ticks, {theme, unit});
        y = covered.y + covered.height + unit / 4;
    }

    /// The number of rows from the current item on, if the last that has room is the current one
    /// and others follow; else 0. The heads of columns have no label and do not count.
    std::size_t rows_without_room() const {
        if (fits(2 * line_height()) || !fits(line_height())) return 0;
        std::size_t end = current;
        while (end < items.size()) {
            const auto* row = std::get_if<PanelRow>(&items[end]);
            if (row == nullptr || row->label.empty()) break;
            ++end;
        }
        return end - current > 1 ? end - current : 0;
    }
    void draw_rest(std::size_t rows) {
        const TextStyle label = style(FontWeight::regular, theme.faint_text);
        const std::string text = "… " + std::to_string(rows) + " more";
        overlay.text(box.x, y, fitted_text(overlay, text, label, box.width), label);
        y += line_height();
    }

    void draw(const PanelNote& note) {
        const std::vector<std::string> lines = note_lines(note);
        if (!fits(note_height(lines.size()) + kept_free)) return;
        for (const std::string& line : lines) {
            overlay.text(box.x, y, line, note_style());
            y += note_height(1);
        }
    }
};

}  // namespace

void insert_before_notes(std::vector<PanelItem>& items, PanelNote note) {
    auto at = items.end();
    while (at != items.begin() && std::holds_alternative<PanelNote>(*std::prev(at))) --at;
    items.insert(at, std::move(note));
}

int draw_side_panel(Overlay& overlay, const PixelRect& box, const Theme& theme, int unit,
                    const std::vector<PanelItem>& items, int kept_free) {
    PanelPainter painter{overlay, box, theme, unit, items, box.y, kept_free};
    for (std::size_t i = 0; i < items.size(); ++i) {
        // Without its heading, an item would seem to belong to the heading above.
        if (std::holds_alternative<PanelHeading>(items[i]) &&
            !painter.fits(painter.gap() + painter.least_below(i)))
            break;
        painter.current = i;
        if (const std::size_t rows = painter.rows_without_room(); rows > 0) {
            painter.draw_rest(rows);
            i += rows - 1;
            continue;
        }
        std::visit([&](const auto& item) { painter.draw(item); }, items[i]);
    }
    return painter.y;
}

}  // namespace scb::render
