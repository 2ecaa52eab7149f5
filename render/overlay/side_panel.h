#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/palette.h"

namespace scb::render {

/// The items of a column of numbers beside a view, from top to bottom.
struct PanelHeading {
    std::string text;
};

/// A row of cells: a label at the left, values at the right in equal columns.
struct PanelRow {
    std::string label;
    std::vector<std::string> values;
    std::vector<std::optional<Rgba8>> swatches = {};  ///< before each value; may be empty
    bool strong = false;
};

/// A color and what it means.
struct PanelKey {
    Rgba8 color;
    std::string text;
};

/// A color, its meaning, its number, and, optionally, its share. A text that is too long gets a
/// second line if nothing below it, except notes, has to give way.
struct PanelLegendRow {
    Rgba8 color;
    std::string text;
    std::string count;
    std::string share;
    bool hatched = false;
};

/// The colors from 0 to 1 as a bar, with labels at places between 0 and 1 below it.
struct PanelScale {
    std::string title;
    std::vector<std::pair<double, std::string>> ticks;
    Rgba8 (*color)(double) = viridis;
};

/// Left out as a whole if it has no room.
struct PanelNote {
    std::string text;  ///< wrapped to the width
};

using PanelItem =
    std::variant<PanelHeading, PanelRow, PanelKey, PanelLegendRow, PanelScale, PanelNote>;

/// Inserts the note before the notes at the end, which are left out sooner.
void insert_before_notes(std::vector<PanelItem>& items, PanelNote note);

/// Draws the items into the box, top down; items that do not fit are left out. If rows
/// after a row have no room, the last line says how many. A heading without room for an item under
/// it ends the panel. Notes leave the lowest `kept_free` pixels free. Returns the y below the last
/// item.
int draw_side_panel(Overlay& overlay, const PixelRect& box, const Theme& theme, int unit,
                    const std::vector<PanelItem>& items, int kept_free = 0);

}  // namespace scb::render
