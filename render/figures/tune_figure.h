#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/picture.h"

namespace scb::render {

/// A setting, as a bar: what it took, as a multiple of what the base did.
struct TuneBar {
    std::string name;  ///< such as "scb2, split cost, descent area"
    double n_v = 1;
    std::optional<double> cost = 1;  ///< see estimated_cost; nothing where it is packed
    struct Times {
        double least = 1, median = 1, most = 1;  ///< of several runs, or all equal
    };
    std::optional<Times> time;  ///< nothing where it was not timed
    bool misses_pairs = false;
    bool recommended = false;
    bool packed = false;  ///< in a layout, of which programs have the use
    bool alike = false;   ///< no difference in time was measured to the recommended one
};

/// What settings take in a scene, the base being 1: their cost and beside it their time, or where
/// they are not timed their volume tests and beside these their cost. At the right is what the
/// recommended one is best in; its row is marked.
struct TuneFigure {
    std::string title, subtitle;
    std::vector<TuneBar> bars;  ///< top down, the base among them, packed ones last
    int runs = 0;               ///< that a time is the median of
    std::string footnote;       ///< small, wrapped; left out where there is no room
    const Theme* theme = &light_theme;
};

/// Composes the figure; all is in the overlay. Both halves have the same rows, whose names are at
/// the left; where the picture is taller than wide one lies below the other, each with its names.
Picture compose(const TuneFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
