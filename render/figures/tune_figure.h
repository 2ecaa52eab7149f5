#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/picture.h"

namespace scb::render {

/// A setting as a bar: its cost and time, as multiples of the base's.
struct TuneBar {
    std::string name;  ///< such as "scb2, split cost, descent area"
    double n_v = 1;
    std::optional<double> cost = 1;  ///< in terms of the base; see cost_words
    struct Times {
        double least = 1, median = 1, most = 1;  ///< of several runs, or all equal
    };
    std::optional<Times> time;  ///< nothing if it was not timed
    bool misses_pairs = false;
    bool recommended = false;
    bool packed = false;  ///< in a packed layout, for programs that use the library
    bool alike = false;   ///< no measured difference in time to the recommended setting
};

/// The costs of settings in a scene, in units of the base: cost and, beside it, time; or, if they
/// are not timed, volume tests and, beside them, cost. The plot at the right has the measure in
/// which the recommended setting is best; its row is marked.
struct TuneFigure {
    std::string title, subtitle;
    std::vector<TuneBar> bars;  ///< top down, the base among them, packed ones last
    int runs = 0;               ///< runs; a time is their median
    std::string footnote;       ///< small, wrapped; left out if there is no room
    const Theme* theme = &light_theme;
};

/// Composes the figure; all is in the overlay. Both halves have the same rows, whose names are at
/// the left. If the picture is taller than wide, one lies below the other, each with its names.
Picture compose(const TuneFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
